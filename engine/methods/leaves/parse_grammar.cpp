#include "engine/methods/leaves/grammar_text.h"
#include "engine/methods/leaves/leaf_grammar.h"

#include "engine/base/random.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr int kDeepestChild = 100;
constexpr std::size_t kMostRules = 10'000;
constexpr int kMostSides = 9'999; // The text's C1 to C9999.

bool is_face(std::string_view word)
{
    return word.size() == 1 && word[0] >= 'A' && word[0] <= 'Z';
}

// "O", "E" or "C" and a number from 1 on, at a word's beginning; the rest is left in `word`.
std::optional<EdgeLabel> take_edge(std::string_view& word)
{
    if (word.empty())
        return std::nullopt;
    char const kind = word[0];
    if (kind == 'O' || kind == 'E') {
        word.remove_prefix(1);
        return kind == 'O' ? EdgeLabel::Origin : EdgeLabel::Extremity;
    }
    int number = 0;
    auto const [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), number);
    if (kind != 'C' || error != std::errc() || number < 1 || number > kMostSides)
        return std::nullopt;
    word.remove_prefix(static_cast<std::size_t>(end - word.data()));
    return side_label(number);
}

std::optional<EdgeLabel> edge_of(std::string_view word)
{
    auto const edge = take_edge(word);
    return word.empty() ? edge : std::nullopt;
}

class Parser {
public:
    Parser(std::string_view text, std::string const& name)
        : text_(text, name)
    {
        grammar_.name = name;
    }

    Result<Grammar> parse()
    {
        while (!text_.is_over()) {
            if (text_.take("#"))
                TRY(directive());
            else
                TRY(rule());
        }
        if (!has_axiom_)
            return text_.fail_here("there is no axiom: \"#axiom : A\" names the first face");
        TRY(check_left_half());
        for (auto const& [face, place] : named_faces_)
            if (!grammar_.faces.contains(face))
                return text_.fail_at(place,
                                     fmt::format("no face {} is defined: \"#define "
                                                 "{}(4,1,0,0,0,1,1)\" makes it a quad",
                                                 face, face));
        for (auto const& use : named_edges_)
            TRY(check_edge(use));
        for (auto const& rule : grammar_.rules)
            TRY(check_names(rule));
        return std::move(grammar_);
    }

private:
    struct EdgeUse {
        char face;
        EdgeLabel edge;
        std::string word;
        bool splits;
        TextPlace place;
    };

    Result<char> face()
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("a face's letter"));
        if (!is_face(word))
            return text_.fail_at(
                place, fmt::format("\"{}\" is no face: a face has one capital letter", word));
        return word[0];
    }
    // One that must be defined somewhere.
    Result<char> known_face()
    {
        auto const place = text_.place();
        char const name = TRY(face());
        named_faces_.emplace_back(name, place);
        return name;
    }

    Result<void> directive()
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("define, axiom, base or another directive"));
        if (word == "define")
            return define();
        if (word == "axiom" || word == "axiome")
            return axiom();
        if (word == "base") {
            grammar_.has_base = true;
            return {};
        }
        if (word == "bare")
            return faces(grammar_.bare);
        if (word == "reach")
            return faces(grammar_.reaching);
        if (word == "outline" || word == "left")
            return outline(word == "left" ? grammar_.left : grammar_.outline.points);
        if (word == "young" || word == "old")
            return color(word == "young" ? grammar_.young : grammar_.old);
        if (word == "steps" || word == "size")
            return adult(word);
        if (word == "margin")
            return margin();
        return text_.fail_at(
            place,
            fmt::format("#{} is none of define, axiom, base, bare, margin, outline, "
                        "left, reach, steps, size, young, old",
                        word));
    }

    Result<void> define()
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("a name"));
        if (text_.next_is("("))
            return define_face(word, place);
        text_.stay_in_line(true);
        TRY(text_.expect("="));
        auto const value_place = text_.place();
        auto const value = TRY(read_expression(text_, grammar_.names));
        if (!text_.is_over())
            return text_.fail_expected("the line's end");
        text_.stay_in_line(false);
        auto const number = grammar_.names.number_of(word);
        grammar_.variables[number] = TRY(constant(value, value_place));
        return {};
    }

    // Value of what a definition says: by then earlier definitions have values, and nothing else.
    Result<double> constant(Expression const& expression, TextPlace const& place)
    {
        std::vector<double> values(grammar_.names.count(), std::nan(""));
        for (auto const& [name, value] : grammar_.variables)
            values[name] = value;
        Random random({});
        double const value = expression.value(values, random);
        if (!std::isfinite(value))
            return text_.fail_at(place,
                                 "this has no finite value, or uses a name that has no "
                                 "value yet");
        return value;
    }

    Result<void> define_face(std::string_view word, TextPlace const& place)
    {
        if (!is_face(word))
            return text_.fail_at(
                place, fmt::format("\"{}\" is no face: a face has one capital letter", word));
        TRY(text_.expect("("));
        Attributes attributes {};
        for (std::size_t i = 0; i < kAttributes; ++i) {
            if (i > 0)
                TRY(text_.expect(","));
            auto const value_place = text_.place();
            auto const value = TRY(read_expression(text_, grammar_.names));
            attributes[i] = TRY(constant(value, value_place));
        }
        TRY(text_.expect(")"));
        if (attributes[kEdgeCount] < 3 || attributes[kEdgeCount] > kMostSides)
            return text_.fail_at(place,
                                 fmt::format("a face has 3 to {} edges, and {} has {}", kMostSides,
                                             word, attributes[kEdgeCount]));
        attributes[kEdgeCount] = std::trunc(attributes[kEdgeCount]);
        grammar_.faces[word[0]] = attributes;
        return {};
    }

    Result<void> axiom()
    {
        TRY(text_.expect(":"));
        grammar_.axiom = TRY(known_face());
        grammar_.axiom_fields = TRY(fields());
        has_axiom_ = true;
        return {};
    }

    Result<void> faces(std::set<char>& to)
    {
        TRY(text_.expect(":"));
        do
            to.insert(TRY(known_face()));
        while (text_.take(","));
        return {};
    }

    // Reads that many numbers in parentheses, all of which have values by now.
    Result<std::vector<double>> numbers(std::size_t least, std::size_t most, std::string_view what)
    {
        auto const place = text_.place();
        auto const expressions = TRY(fields());
        if (expressions.size() < least || expressions.size() > most)
            return text_.fail_at(place, fmt::format("{}", what));
        std::vector<double> made;
        for (auto const& expression : expressions) {
            if (expression.empty())
                return text_.fail_at(place, fmt::format("{}", what));
            made.push_back(TRY(constant(expression, place)));
        }
        return made;
    }

    Result<void> check_left_half()
    {
        auto const& right = grammar_.outline.points;
        auto const& left = grammar_.left;
        if (left.empty() || (!right.empty() && left.back().at == right.back().at))
            return {};
        return text_.fail_at(left_place_, "#left ends at the tip at which #outline ends");
    }

    // A margin shapes the outline; where there is none it changes nothing.
    Result<void> margin()
    {
        TRY(text_.expect(":"));
        auto const place = text_.place();
        auto const kind = TRY(text_.word("teeth, scallops or sinus"));
        if (kind != "teeth" && kind != "scallops" && kind != "sinus")
            return text_.fail_at(place,
                                 fmt::format("\"{}\" is none of teeth, scallops, sinus", kind));
        auto const values
            = TRY(numbers(2, 3, "a margin has a number, a depth and, if wanted, a lean"));
        auto& outline = grammar_.outline;
        outline.margin
            = kind == "teeth" ? HalfOutline::Margin::Teeth : HalfOutline::Margin::Scallops;
        constexpr double kMostTeeth = 500;
        outline.count = static_cast<int>(std::clamp(values[0], 0.0, kMostTeeth));
        outline.depth = kind == "sinus" ? -values[1] : values[1];
        outline.lean = values.size() > 2 ? values[2] : 0;
        return {};
    }

    // "(0.1,0.2) (0.3,0.5,1)": from the stalk's end, which is (0,0), to the tip; 1 is a corner.
    Result<void> outline(std::vector<HalfOutline::Point>& points)
    {
        constexpr std::size_t kMostPoints = 500;
        auto const place = text_.place();
        TRY(text_.expect(":"));
        points = { { .is_corner = true } };
        while (text_.next_is("(")) {
            auto const values = TRY(numbers(2, 3, "a point is (x,y), or (x,y,1) at a corner"));
            points.push_back({ .at = { values[0], values[1] },
                               .is_corner = values.size() > 2 && values[2] != 0 });
            if (points.size() > kMostPoints)
                return text_.fail_here(
                    fmt::format("an outline has no more than {} points", kMostPoints));
        }
        if (points.size() < 3 || points.back().at.x() != 0 || points.back().at.y() <= 0)
            return text_.fail_at(place,
                                 "an outline has two points and more; the last is the tip, whose x "
                                 "is 0 and whose y is above 0");
        if (&points == &grammar_.left)
            left_place_ = place;
        return {};
    }

    Result<void> color(Vec3& to)
    {
        auto const place = text_.place();
        auto const values = TRY(numbers(3, 3, "a colour is (red,green,blue), each 0 to 255"));
        for (Eigen::Index i = 0; i < 3; ++i) {
            double const value = values[static_cast<std::size_t>(i)];
            if (value < 0 || value > 255)
                return text_.fail_at(place, "a colour is (red,green,blue), each 0 to 255");
            to[i] = value / 255;
        }
        return {};
    }

    // Reads properties of the adult leaf: "#steps(9)", "#size(80)".
    Result<void> adult(std::string_view what)
    {
        constexpr double kMost = 1000;
        auto const place = text_.place();
        auto const message = fmt::format("#{} has one number above 0 and up to {}", what, kMost);
        auto const values = TRY(numbers(1, 1, message));
        if (!(values[0] > 0 && values[0] <= kMost))
            return text_.fail_at(place, message);
        if (what == "steps")
            grammar_.steps = static_cast<int>(values[0]);
        else
            grammar_.size_mm = values[0];
        return {};
    }

    // Nothing where there are no parentheses.
    Result<Fields> fields()
    {
        Fields made;
        if (!text_.take("("))
            return made;
        do {
            if (made.size() == kAttributes)
                return text_.fail_here(
                    fmt::format("a face has no more than {} fields", kAttributes));
            made.emplace_back();
            if (text_.next_is(",") || text_.next_is(")"))
                continue;
            if (text_.take("<")) {
                made.back() = TRY(read_expression(text_, grammar_.names, true));
                TRY(text_.expect(">"));
            } else {
                made.back() = TRY(read_expression(text_, grammar_.names));
            }
        } while (text_.take(","));
        TRY(text_.expect(")"));
        return made;
    }

    Result<void> rule()
    {
        if (grammar_.rules.size() == kMostRules)
            return text_.fail_here(fmt::format("a grammar has no more than {} rules", kMostRules));
        Rule rule;
        rule.place = text_.place();
        rule.name = TRY(text_.word("a rule's name"));
        rule.face = TRY(known_face());
        if (text_.take(":")) {
            rule.kind = TRY(gluing());
        } else {
            TRY(formal_names(rule));
            TRY(blocks(rule));
            if (!text_.take_arrow())
                return text_.fail_expected("an arrow");
            TRY(successor(rule));
        }
        grammar_.rules.push_back(std::move(rule));
        return {};
    }

    Result<void> formal_names(Rule& rule)
    {
        if (!text_.take("("))
            return {};
        do {
            if (rule.formal.size() == kAttributes)
                return text_.fail_here(
                    fmt::format("a face has no more than {} attributes", kAttributes));
            rule.formal.emplace_back();
            if (!text_.next_is(",") && !text_.next_is(")")) {
                auto const name = TRY(text_.word("a name"));
                rule.formal.back() = grammar_.names.number_of(name);
            }
        } while (text_.take(","));
        return text_.expect(")");
    }

    Result<void> blocks(Rule& rule)
    {
        if (!text_.next_is("{"))
            return {};
        rule.always = TRY(statements());
        TRY(expect_block("condition"));
        if (!text_.next_is("}"))
            rule.condition = TRY(read_expression(text_, grammar_.names));
        TRY(text_.expect("}"));
        if (!text_.next_is("{"))
            return text_.fail_here("a rule has three blocks or none: the third is missing");
        rule.if_met = TRY(statements());
        return {};
    }

    Result<void> expect_block(std::string_view what)
    {
        if (!text_.take("{"))
            return text_.fail_here(
                fmt::format("a rule has three blocks or none: the {} is missing", what));
        return {};
    }

    Result<std::vector<Statement>> statements()
    {
        std::vector<Statement> made;
        TRY(text_.expect("{"));
        while (!text_.next_is("}")) {
            auto const name = TRY(text_.word("a name or \"}\""));
            TRY(text_.expect("="));
            auto value = TRY(read_expression(text_, grammar_.names));
            made.push_back({ grammar_.names.number_of(name), std::move(value) });
            if (!text_.next_is("}") && !text_.take(";"))
                return text_.fail_expected("\";\" or \"}\"");
        }
        TRY(text_.expect("}"));
        return made;
    }

    // "OBC": an edge and two faces; or the face itself, with what grows on it.
    Result<void> successor(Rule& rule)
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("a face or a split, such as OBC"));
        auto rest = word;
        auto const edge = take_edge(rest);
        if (edge && rest.size() == 2 && is_face(rest.substr(0, 1)) && is_face(rest.substr(1))) {
            for (char const part : rest)
                named_faces_.emplace_back(part, place);
            rule.kind = Splitting { *edge, rest[0], rest[1] };
            named_edges_.push_back(
                { rule.face, *edge, std::string(word.substr(0, word.size() - 2)), true, place });
            return {};
        }
        if (!is_face(word) || word[0] != rule.face)
            return text_.fail_at(
                place, fmt::format("a growing rule goes on with its own face {}", rule.face));
        Growing growing;
        growing.fields = TRY(fields());
        growing.children = TRY(children(rule.face, growing.fields, 0));
        if (growing.children.empty())
            return text_.fail_expected("\"[\" and a face that grows");
        rule.kind = std::move(growing);
        return {};
    }

    Result<std::vector<Child>> children(char parent, Fields const& parent_fields, int depth)
    {
        if (depth > kDeepestChild)
            return text_.fail_here(fmt::format("faces are nested deeper than {}", kDeepestChild));
        std::vector<Child> made;
        while (text_.take("[")) {
            Child child;
            child.place = text_.place();
            child.face = TRY(known_face());
            child.fields = TRY(fields());
            child.children = TRY(children(child.face, child.fields, depth + 1));
            TRY(text_.expect("]"));
            child.edge_place = text_.place();
            auto const word = TRY(text_.word("an edge: O, E, C1, C2 and so on"));
            auto const edge = edge_of(word);
            if (!edge)
                return text_.fail_at(
                    child.edge_place,
                    fmt::format("\"{}\" is no edge: they are O, E, C1, C2 and so on", word));
            child.edge = *edge;
            // An overloaded number of edges is looked at when it is known.
            if (parent_fields.empty() || parent_fields[kEdgeCount].empty())
                named_edges_.push_back(
                    { parent, *edge, std::string(word), false, child.edge_place });
            made.push_back(std::move(child));
        }
        return made;
    }

    // "B_C2"
    Result<FaceEdge> face_edge()
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("a face's edge, such as B_C2"));
        auto const edge = word.size() > 2 ? edge_of(word.substr(2)) : std::nullopt;
        if (!edge || !is_face(word.substr(0, 1)) || word[1] != '_')
            return text_.fail_at(place,
                                 fmt::format("\"{}\" is no face's edge, such as B_C2", word));
        named_faces_.emplace_back(word[0], place);
        named_edges_.push_back({ word[0], *edge, std::string(word.substr(2)), false, place });
        return FaceEdge { word[0], *edge };
    }

    // "A_C1 < B_C2 -> A_C1 | B_C2", behind the colon.
    Result<Gluing> gluing()
    {
        Gluing made;
        made.first = TRY(face_edge());
        TRY(text_.expect("<"));
        made.second = TRY(face_edge());
        if (!text_.take_arrow())
            return text_.fail_expected("an arrow");
        auto const place = text_.place();
        auto const first = TRY(face_edge());
        TRY(text_.expect("|"));
        auto const second = TRY(face_edge());
        if (first != made.first || second != made.second)
            return text_.fail_at(place, "what is glued is named twice, in one order");
        return made;
    }

    Result<void> check_edge(EdgeUse const& use) const
    {
        auto const count = static_cast<int>(grammar_.faces.at(use.face)[kEdgeCount]);
        if (!has_edge(count, use.edge))
            return text_.fail_at(
                use.place,
                fmt::format("a face {} has {} edges and no {}", use.face, count, use.word));
        bool const is_side = use.edge != EdgeLabel::Origin && use.edge != EdgeLabel::Extremity;
        if (use.splits && (count < 4 || (count % 2 == 1 && is_side)))
            return text_.fail_at(use.place,
                                 fmt::format("a face {} of {} edges cannot be split along {}",
                                             use.face, count, use.word));
        return {};
    }

    // Checks that what a rule reads has a value: a variable's, its face's attributes', or one that
    // it gives.
    Result<void> check_names(Rule const& rule) const
    {
        std::vector<bool> has_value(grammar_.names.count());
        for (auto const name : { NameTable::kStep, NameTable::kFinalStep, NameTable::kAge,
                                 NameTable::kBlade, NameTable::kVariation })
            has_value[name] = true;
        for (auto const& [name, value] : grammar_.variables)
            has_value[name] = true;
        for (auto const& name : rule.formal)
            if (name)
                has_value[*name] = true;
        std::vector<Expression const*> read { &rule.condition };
        for (auto const* block : { &rule.always, &rule.if_met })
            for (auto const& statement : *block) {
                has_value[statement.name] = true;
                read.push_back(&statement.value);
            }
        if (auto const* const growing = std::get_if<Growing>(&rule.kind)) {
            for (auto const& field : growing->fields)
                read.push_back(&field);
            add_fields(growing->children, read);
        }
        for (auto const* const expression : read)
            for (auto const& operation : expression->operations)
                if (operation.kind == Operation::Kind::Name && !has_value[operation.target])
                    return text_.fail_at(rule.place,
                                         fmt::format("rule {} reads {}, to which nothing gives a "
                                                     "value",
                                                     rule.name,
                                                     grammar_.names.name(operation.target)));
        return {};
    }

    static void add_fields(std::vector<Child> const& children, std::vector<Expression const*>& to)
    {
        for (auto const& child : children) {
            for (auto const& field : child.fields)
                to.push_back(&field);
            add_fields(child.children, to);
        }
    }

    GrammarText text_;
    Grammar grammar_;
    bool has_axiom_ = false;
    TextPlace left_place_;
    std::vector<std::pair<char, TextPlace>> named_faces_;
    std::vector<EdgeUse> named_edges_;
};

} // namespace

Result<Grammar> parse_grammar(std::string_view text, std::string const& name)
{
    return Parser(text, name).parse();
}

} // namespace tractus::leaf
