#include "engine/methods/leaves/print_grammar.h"

#include "engine/methods/leaves/compound_rachis.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace tractus::leaf {

namespace {

// Letters for the faces of main veins that have side veins, except the midrib. Main veins without
// side veins have the letter P.
constexpr std::string_view kBearingFaces = "QTVWXYZABDFGIJ";
constexpr char kPlainFace = 'P';
constexpr double kKnot = 0.008; // Length of a knot, as a share of the blade's length.

// Formats a number with as few decimals as necessary, at most four.
std::string text_of(double value)
{
    auto text = fmt::format("{:.4f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text == "-0" ? "0" : text;
}

void define(std::string& text, std::string_view name, double value)
{
    text += fmt::format("#define {} = {}\n", name, text_of(value));
}

class GrammarPrinter {
public:
    explicit GrammarPrinter(DrawnLeaf const& leaf)
        : leaf_(leaf)
    {
        std::size_t bearing = 0;
        for (auto const& main : leaf.mains) {
            bool const is_plain = main.knots.empty() || bearing == kBearingFaces.size();
            if (faces_.empty())
                faces_ += 'M';
            else
                faces_ += is_plain ? kPlainFace : kBearingFaces[bearing++];
        }
    }

    std::string print(std::string const& title)
    {
        text_ = fmt::format("@ {} @\n", without_signs(title));
        print_adult();
        print_half("#outline", leaf_.right);
        if (!leaf_.left.empty())
            print_half("#left", leaf_.left);
        print_margin();
        print_fastening();
        print_shape();
        print_veins();
        if (leaf_.is_compound())
            print_leaflets();
        print_faces();
        if (leaf_.is_compound())
            print_compound_begin();
        else
            print_begin();
        for (std::size_t k = 0; k < leaf_.mains.size(); ++k)
            print_rules(k);
        return std::move(text_);
    }

private:
    bool has_hub() const { return leaf_.mains.size() > 1; }
    // Number of derivation steps after which main veins have their first pieces.
    std::size_t steps_before_veins() const { return has_hub() || leaf_.is_compound() ? 2 : 1; }
    bool is_curved() const { return leaf_.side_curve_deg != 0 || leaf_.side_curve_at_tip_deg != 0; }

    // Replaces line ends, and @, which would end the comment, by blanks.
    static std::string without_signs(std::string title)
    {
        std::ranges::replace_if(
            title, [](char c) { return c == '@' || c == '\n' || c == '\r'; }, ' ');
        return title;
    }

    void print_adult()
    {
        std::size_t knots = 0;
        for (auto const& main : leaf_.mains)
            knots = std::max(knots, main.knots.size());
        text_ += fmt::format("#size({})\n#steps({})\n", text_of(leaf_.size_mm),
                             knots + steps_before_veins());
        text_ += "#young(92,138,56)\n#old(184,128,41)\n";
    }

    void print_half(std::string_view statement, DrawnLeaf::Half const& half)
    {
        constexpr std::size_t kInLine = 6;
        text_ += fmt::format("{} :", statement);
        for (std::size_t i = 1; i < half.size(); ++i) {
            auto const& [at, is_corner] = half[i];
            text_ += i > 1 && i % kInLine == 1 ? "\n   " : " ";
            text_ += fmt::format("({},{}{})", text_of(at.x()), text_of(at.y()),
                                 is_corner ? ",1" : "");
        }
        text_ += "\n";
    }

    void print_margin()
    {
        if (leaf_.margin == HalfOutline::Margin::Entire)
            return;
        bool const has_teeth = leaf_.margin == HalfOutline::Margin::Teeth;
        text_ += fmt::format("#margin : {}({}, {}, {})\n",
                             has_teeth                   ? "teeth"
                                 : leaf_.tooth_depth < 0 ? "sinus"
                                                         : "scallops",
                             leaf_.tooth_count,
                             text_of(has_teeth ? leaf_.tooth_depth : std::abs(leaf_.tooth_depth)),
                             text_of(leaf_.tooth_lean));
    }

    void print_fastening()
    {
        text_ += fmt::format("#base\n#bare : {}\n#reach : M",
                             leaf_.is_compound() ? "S, P, X, Q, T" : "S");
        std::string seen = "M";
        for (char const face : faces_ + (has_sides() ? is_curved() ? "RULN" : "RL" : ""))
            if (seen.find(face) == std::string::npos) {
                seen += face;
                text_ += fmt::format(", {}", face);
            }
        text_ += "\n";
    }

    bool has_sides() const
    {
        return std::ranges::any_of(leaf_.mains, [](auto const& main) {
            return std::ranges::any_of(
                main.knots, [](auto const& knot) { return knot.right_deg || knot.left_deg; });
        });
    }

    void print_shape()
    {
        text_ += leaf_.is_compound()
            ? "@ The length of the rachis below the first leaflet, and the midrib's width; all "
              "lengths are\n  shares of the longest leaflet's. @\n"
            : "@ The stalk's length and the midrib's width; all lengths are shares of the "
              "blade's. @\n";
        define(text_, "stalk", leaf_.stalk);
        define(text_, "width", leaf_.width);
        text_
            += "@ The midrib bends downwards so far, with so much more of it towards the tip; the "
               "blade\n  rises so far beside it. @\n";
        define(text_, "bend", leaf_.bend_deg);
        define(text_, "droop", leaf_.droop_deg);
        define(text_, "rise", leaf_.rise_deg);
        text_ += "@ Angles differ so far from leaf to leaf. @\n";
        define(text_, "spread", leaf_.spread_deg);
        if (is_curved()) {
            text_ += "@ Side veins turn so far forwards, at the base and at the tip. @\n";
            define(text_, "curve", leaf_.side_curve_deg);
            define(text_, "curve_at_tip", leaf_.side_curve_at_tip_deg);
        }
    }

    static std::string prefix_of(std::size_t main)
    {
        return main == 0 ? "" : fmt::format("main{}_", main);
    }

    void print_veins()
    {
        if (has_hub()) {
            text_ += "@ Main veins beside the midrib, from the right round to the left: their "
                     "angles from the\n  leaf's axis, and how far they turn to the right. They "
                     "begin on a hub so long. @\n";
            define(text_, "hub", leaf_.hub);
        }
        for (std::size_t k = 1; k < leaf_.mains.size(); ++k) {
            define(text_, prefix_of(k) + "angle", leaf_.mains[k].angle_deg);
            if (!leaf_.mains[k].knots.empty())
                define(text_, prefix_of(k) + "curve", leaf_.mains[k].curve_deg);
        }
        if (has_sides())
            text_ += "@ Side veins: where they begin, as a share of the vein that bears them, and "
                     "their angles\n  from it on the right and on the left. @\n";
        for (std::size_t k = 0; k < leaf_.mains.size(); ++k)
            print_knots(k);
    }

    void print_knots(std::size_t main)
    {
        auto const prefix = prefix_of(main);
        for (std::size_t i = 0; i < leaf_.mains[main].knots.size(); ++i) {
            auto const& knot = leaf_.mains[main].knots[i];
            define(text_, fmt::format("{}at{}", prefix, i + 1), knot.at);
            if (knot.right_deg)
                define(text_, fmt::format("{}right{}", prefix, i + 1), *knot.right_deg);
            if (knot.left_deg)
                define(text_, fmt::format("{}left{}", prefix, i + 1), *knot.left_deg);
        }
    }

    // Number of edges of the hub to the left of the midrib, and as many to its right.
    std::size_t hub_sides() const { return std::max<std::size_t>(rights().size(), lefts().size()); }
    std::vector<std::size_t> rights() const { return mains_beside(true); }
    std::vector<std::size_t> lefts() const { return mains_beside(false); }
    std::vector<std::size_t> mains_beside(bool right) const
    {
        std::vector<std::size_t> made;
        for (std::size_t k = 1; k < leaf_.mains.size(); ++k)
            if ((leaf_.mains[k].angle_deg >= 0) == right)
                made.push_back(k);
        return made;
    }

    static std::string leaflet_name(std::size_t i) { return fmt::format("leaflet{}_", i + 1); }

    void print_leaflet(std::string const& name, DrawnLeaf::Leaflet const& leaflet, bool is_first)
    {
        if (!is_first) {
            define(text_, name + "piece", leaflet.piece);
            define(text_, name + "turn", leaflet.turn_deg);
        }
        if (leaflet.size == 0)
            return;
        define(text_, name + "angle", leaflet.angle_deg);
        define(text_, name + "stalk", leaflet.stalk);
        define(text_, name + "size", leaflet.size);
    }

    void print_leaflets()
    {
        text_
            += "@ Leaflets from the base on: how long the rachis is from the one before, and how "
               "far it turns\n  to the right there; the leaflet's angle from it, on the right and, "
               "below 0, on the left; its\n  stalk and its blade. @\n";
        for (std::size_t i = 0; i < leaf_.leaflets.size(); ++i)
            print_leaflet(leaflet_name(i), leaf_.leaflets[i], i == 0);
        print_leaflet("end_", leaf_.end, false);
    }

    // Writes the stalk of a leaflet. `angle` is the expression for its turn.
    static std::string leaflet_stalk(std::string const& name, std::string const& angle)
    {
        return fmt::format("[Q(,,,,{},{}stalk,{}size * width)]", angle, name, name);
    }

    // The rachis grows in one rule, since each of its pieces stands on the one before. The leaflets
    // then grow in the next step, and each sets the size of its blade from the width of its stalk.
    void print_compound_begin()
    {
        text_ += "#axiom : S\nstart S\n      -> S";
        for (std::size_t i = 0; i < leaf_.leaflets.size(); ++i) {
            auto const name = leaflet_name(i);
            bool const is_right = leaf_.leaflets[i].angle_deg > 0;
            auto const angle = fmt::format("nran({}angle, spread * variation)", name);
            auto const next = i + 1 < leaf_.leaflets.size() ? leaflet_name(i + 1) : "end_";
            text_ += fmt::format("[X{}{}\n         [P(,,,,-{}turn,{}piece,)",
                                 leaflet_stalk(name, is_right ? "90 - " + angle : "-90 - " + angle),
                                 is_right ? "C1" : "C2", next, next);
        }
        if (leaf_.end.size > 0)
            text_ += leaflet_stalk("end_", "-nran(end_angle, spread * variation)") + "E";
        for (std::size_t i = 0; i < leaf_.leaflets.size(); ++i)
            text_ += "]E]E";
        text_
            += fmt::format("\nleaflet Q(n,t,a,b,c,l,w) {{ {}\n      {} }} {{}}"
                           " {{ blade = w / width }}\n      -> Q[T(,,,,,,w)[M(,,,bent,,to,w)]E]E\n",
                           first_piece(0), bending());
    }

    void print_faces()
    {
        if (leaf_.is_compound()) {
            text_ += fmt::format("#define S(4,1,0,0,90,stalk,width * {0})\n"
                                 "#define P(4,1,0,0,0,1,width * {0})\n"
                                 "#define X(4,1,0,0,0,{1},width * {0})\n"
                                 "#define Q(4,1,0,0,0,1,width)\n"
                                 "#define T(4,1,0,0,0,{2},width)\n",
                                 text_of(kRachisWidths), text_of(kLeafletKnot),
                                 text_of(kLeafletStalkEnd));
        } else {
            text_ += "#define S(4,1,0,0,90,stalk,width * 1.25)\n";
        }
        if (has_hub())
            text_ += fmt::format("#define H({},1,0,0,0,hub,width * 1.1)\n", 2 + 2 * hub_sides());
        text_ += "#define M(4,1,0,0,0,1,width)\n";
        std::string seen = "M";
        for (char const face : faces_)
            if (seen.find(face) == std::string::npos) {
                seen += face;
                text_ += fmt::format("#define {}(4,1,0,0,0,1,width * 0.8)\n", face);
            }
        if (seen.size() > 1 || has_knots())
            text_ += fmt::format("#define K(4,1,0,0,0,{},width)\n", text_of(kKnot));
        if (!has_sides())
            return;
        for (char const face : std::string(is_curved() ? "RULN" : "RL"))
            text_ += fmt::format("#define {}(4,1,0,0,0,1,width * {})\n", face,
                                 face == 'U' || face == 'N' ? "0.1" : "0.22");
    }

    bool has_knots() const
    {
        return std::ranges::any_of(leaf_.mains,
                                   [](auto const& main) { return !main.knots.empty(); });
    }

    // Writes the statements that set the range of a main vein's first piece, the variables `from`
    // and `to`, as shares of the vein's length.
    std::string first_piece(std::size_t main) const
    {
        auto const begin = main == 0 && has_hub() ? "hub" : "0";
        if (leaf_.mains[main].knots.empty())
            return fmt::format("from = {}; to = 1;", begin);
        return fmt::format("from = {}; to = step >= finalstep ? 1 : {}at1;", begin,
                           prefix_of(main));
    }

    static std::string bending()
    {
        return "bent = (to - from) * (bend + droop * (to + from - 1));";
    }

    void print_begin()
    {
        text_ += "#axiom : S\n";
        if (!has_hub()) {
            text_ += fmt::format("start S {{ {}\n      {} }} {{}} {{}}\n"
                                 "      -> S[M(,,,bent,,to,)]E\n",
                                 first_piece(0), bending());
            return;
        }
        text_ += "start S -> S[H]E\n";
        text_ += fmt::format("hub H {{ {}\n      {}\n      share = (to - from) / (1 - from);",
                             first_piece(0), bending());
        for (std::size_t k = 1; k < leaf_.mains.size(); ++k)
            if (!leaf_.mains[k].knots.empty())
                text_ += fmt::format("\n      share{0} = step >= finalstep ? 1 : main{0}_at1;", k);
        text_ += " } {} {}\n      -> H[M(,,,bent,,share,)]E";
        auto const right = rights();
        for (std::size_t i = 0; i < right.size(); ++i)
            print_main(right[i], i + 1);
        auto const left = lefts();
        for (std::size_t i = 0; i < left.size(); ++i)
            print_main(left[i], 2 * hub_sides() - left.size() + i + 1);
        text_ += "\n";
    }

    void print_main(std::size_t main, std::size_t side)
    {
        bool const is_right = leaf_.mains[main].angle_deg >= 0;
        bool const is_plain = leaf_.mains[main].knots.empty();
        std::string const turn
            = is_plain ? "" : fmt::format(" + main{0}_curve * 0.5 * share{0}", main);
        text_ += fmt::format(
            "\n         [{}(,,,-rise * sin(fabs(main{}_angle)),{} - nran(main{}_angle{}, "
            "spread * variation),{},)]C{}",
            faces_[main], main, is_right ? "90" : "-90", main, turn,
            is_plain ? "" : fmt::format("share{}", main), side);
    }

    // Prints the rules of a main vein: one for each of its knots.
    void print_rules(std::size_t main)
    {
        auto const& knots = leaf_.mains[main].knots;
        if (main > 0 && faces_[main] == kPlainFace)
            return;
        double const taper = std::pow(0.35, 1.0 / double(std::max<std::size_t>(knots.size(), 1)));
        std::size_t const made_at = steps_before_veins();
        for (std::size_t i = 0; i < knots.size(); ++i)
            print_rule(main, i, made_at + i + 1, text_of(taper));
    }

    void print_rule(std::size_t main, std::size_t i, std::size_t step, std::string const& taper)
    {
        auto const& knots = leaf_.mains[main].knots;
        auto const prefix = prefix_of(main);
        bool const is_last = i + 1 == knots.size();
        char const face = faces_[main];
        text_ += fmt::format(
            "{0}vein{1} {2}(n,t,a,b,c,l,w) {{ from = {0}at{1}; to = {3};\n"
            "      {4} }}\n      {{ step == {5} && step <= finalstep }}"
            " {{ share = (to - from - {6}) / (1 - from - {6}) }}\n",
            prefix, i + 1, face,
            is_last ? std::string("1")
                    : fmt::format("step >= finalstep ? 1 : {}at{}", prefix, i + 2),
            (main == 0 ? bending() : turning(main, i))
                + (is_curved() ? "\n      curved = curve + from * (curve_at_tip - curve);" : ""),
            step, text_of(kKnot));
        text_ += fmt::format("      -> {}[K(,,,,{},,w * {})", face, main == 0 ? "" : "turn", taper);
        print_side(knots[i].right_deg.has_value(), prefix + "right", i, true);
        print_side(knots[i].left_deg.has_value(), prefix + "left", i, false);
        text_ += fmt::format("\n         [{}(,,,{},{},share,w * {})]E]E\n", face,
                             main == 0 ? "bent" : "", main == 0 ? "" : "turn", taper);
    }

    // Writes the statement for the turn of a curved main vein at a knot, which accounts for the
    // vein's curvature from half-way to the knot before to half-way to the next one. The knot and
    // the piece behind it each turn by `turn`.
    static std::string turning(std::size_t main, std::size_t i)
    {
        auto const before = i == 0 ? std::string("0") : fmt::format("main{}_at{}", main, i);
        return fmt::format("turn = -main{}_curve * 0.25 * (to - {});", main, before);
    }

    void print_side(bool exists, std::string const& name, std::size_t i, bool right)
    {
        if (!exists)
            return;
        auto const number = fmt::format("{}{}", name, i + 1);
        auto const angle = fmt::format("nran({}{}, spread * variation)", number,
                                       is_curved() ? " - curved / 4" : "");
        text_ += fmt::format("\n         [{}(,,,-rise * sin({}),{},{},)", right ? 'R' : 'L', number,
                             right ? "90 - " + angle : angle + " - 90", is_curved() ? "0.5" : "");
        if (is_curved())
            text_ += right ? "[U(,,,,curved / 2,,)]E" : "[N(,,,,-curved / 2,,)]E";
        text_ += right ? "]C1" : "]C2";
    }

    DrawnLeaf const& leaf_;
    std::string faces_; // Face letter of each main vein.
    std::string text_;
};

// Reads a grammar's variables by name, and records whether one was missing.
class NumberReader {
public:
    explicit NumberReader(Grammar const& grammar)
        : grammar_(grammar)
        , names_(grammar.names)
    {
    }

    std::optional<double> find(std::string const& name)
    {
        auto const found = grammar_.variables.find(names_.number_of(name));
        return found == grammar_.variables.end() ? std::nullopt : std::optional(found->second);
    }
    double get(std::string const& name)
    {
        auto const found = find(name);
        lacks_one_ = lacks_one_ || !found;
        return found.value_or(0);
    }
    bool lacks_one() const { return lacks_one_; }

    std::vector<DrawnLeaf::Knot> knots(std::string const& prefix)
    {
        std::vector<DrawnLeaf::Knot> made;
        while (auto const at = find(fmt::format("{}at{}", prefix, made.size() + 1)))
            made.push_back({ .at = *at,
                             .right_deg = find(fmt::format("{}right{}", prefix, made.size() + 1)),
                             .left_deg = find(fmt::format("{}left{}", prefix, made.size() + 1)) });
        return made;
    }

private:
    Grammar const& grammar_;
    NameTable names_; // Copy of the grammar's names, because looking up an unknown name adds it.
    bool lacks_one_ = false;
};

std::optional<DrawnLeaf::Leaflet> read_leaflet(NumberReader& numbers, std::string const& name)
{
    auto const piece = numbers.find(name + "piece");
    auto const size = numbers.find(name + "size");
    if (!piece && !size)
        return std::nullopt;
    return DrawnLeaf::Leaflet { .piece = piece ? *piece : numbers.get("stalk"),
                                .turn_deg = numbers.find(name + "turn").value_or(0),
                                .angle_deg = size ? numbers.get(name + "angle") : 0,
                                .stalk = size ? numbers.get(name + "stalk") : 0,
                                .size = size.value_or(0) };
}

} // namespace

std::string print_grammar(DrawnLeaf const& leaf, std::string const& title)
{
    return GrammarPrinter(leaf).print(title);
}

std::optional<DrawnLeaf> read_drawn_leaf(Grammar const& grammar)
{
    NumberReader numbers(grammar);
    DrawnLeaf leaf;
    leaf.size_mm = grammar.size_mm;
    leaf.right = grammar.outline.points;
    leaf.left = grammar.left;
    leaf.margin = grammar.outline.margin;
    leaf.tooth_count = grammar.outline.count;
    leaf.tooth_depth = grammar.outline.depth;
    leaf.tooth_lean = grammar.outline.lean;
    leaf.stalk = numbers.get("stalk");
    leaf.width = numbers.get("width");
    leaf.bend_deg = numbers.get("bend");
    leaf.droop_deg = numbers.get("droop");
    leaf.rise_deg = numbers.get("rise");
    leaf.spread_deg = numbers.get("spread");
    leaf.side_curve_deg = numbers.find("curve").value_or(0);
    leaf.side_curve_at_tip_deg = numbers.find("curve_at_tip").value_or(0);
    leaf.hub = numbers.find("hub").value_or(0);
    leaf.mains.push_back({ .knots = numbers.knots("") });
    while (auto const angle = numbers.find(fmt::format("main{}_angle", leaf.mains.size()))) {
        auto const prefix = fmt::format("main{}_", leaf.mains.size());
        leaf.mains.push_back({ .angle_deg = *angle,
                               .curve_deg = numbers.find(prefix + "curve").value_or(0),
                               .knots = numbers.knots(prefix) });
    }
    while (auto const leaflet
           = read_leaflet(numbers, fmt::format("leaflet{}_", leaf.leaflets.size() + 1)))
        leaf.leaflets.push_back(*leaflet);
    leaf.end = read_leaflet(numbers, "end_").value_or(DrawnLeaf::Leaflet {});
    if (numbers.lacks_one() || leaf.right.size() < 2)
        return std::nullopt;
    return leaf;
}

} // namespace tractus::leaf
