#include "engine/methods/leaves/grammar_reader.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr int kDeepestChild = 100;
constexpr std::size_t kMaxRules = 10'000;

// Parses a rule of one of three kinds: growing, splitting or gluing (Peyrat et al. 2008, section
// 3).
class RuleText {
public:
    explicit RuleText(GrammarReader& reader)
        : reader_(reader)
        , text_(reader.text)
        , grammar_(reader.grammar)
    {
    }

    Result<void> read()
    {
        if (grammar_.rules.size() == kMaxRules)
            return text_.fail_here(fmt::format("a grammar has no more than {} rules", kMaxRules));
        Rule rule;
        rule.place = text_.place();
        rule.name = TRY(text_.word("a rule's name"));
        rule.face = TRY(reader_.known_face());
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

private:
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

    // Parses the successor of a rule: either an edge and two faces, such as "OBC", or the face
    // itself with the faces that grow on it.
    Result<void> successor(Rule& rule)
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("a face or a split, such as OBC"));
        auto rest = word;
        auto const edge = take_edge(rest);
        if (edge && rest.size() == 2 && is_face(rest.substr(0, 1)) && is_face(rest.substr(1))) {
            for (char const part : rest)
                reader_.named_faces.emplace_back(part, place);
            rule.kind = Splitting { *edge, rest[0], rest[1] };
            reader_.named_edges.push_back(
                { rule.face, *edge, std::string(word.substr(0, word.size() - 2)), true, place });
            return {};
        }
        if (!is_face(word) || word[0] != rule.face)
            return text_.fail_at(
                place, fmt::format("a growing rule goes on with its own face {}", rule.face));
        Growing growing;
        growing.fields = TRY(reader_.fields());
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
            child.face = TRY(reader_.known_face());
            child.fields = TRY(reader_.fields());
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
            // If the rule overrides the parent's number of edges, the edge is checked when the rule
            // is applied, because only then that number is known.
            if (parent_fields.empty() || parent_fields[kEdgeCount].empty())
                reader_.named_edges.push_back(
                    { parent, *edge, std::string(word), false, child.edge_place });
            made.push_back(std::move(child));
        }
        return made;
    }

    // Parses an edge of a face, such as "B_C2".
    Result<FaceEdge> face_edge()
    {
        auto const place = text_.place();
        auto const word = TRY(text_.word("a face's edge, such as B_C2"));
        auto const edge = word.size() > 2 ? edge_of(word.substr(2)) : std::nullopt;
        if (!edge || !is_face(word.substr(0, 1)) || word[1] != '_')
            return text_.fail_at(place,
                                 fmt::format("\"{}\" is no face's edge, such as B_C2", word));
        reader_.named_faces.emplace_back(word[0], place);
        reader_.named_edges.push_back(
            { word[0], *edge, std::string(word.substr(2)), false, place });
        return FaceEdge { word[0], *edge };
    }

    // Parses a gluing rule after its colon, such as "A_C1 < B_C2 -> A_C1 | B_C2".
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

    GrammarReader& reader_;
    GrammarText& text_;
    Grammar& grammar_;
};

} // namespace

Result<void> read_rule(GrammarReader& reader)
{
    return RuleText(reader).read();
}

} // namespace tractus::leaf
