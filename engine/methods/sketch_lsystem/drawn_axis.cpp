#include "engine/methods/sketch_lsystem/drawn_axis.h"

#include "engine/methods/sketch_lsystem/axis_turtle.h"
#include "engine/methods/sketch_lsystem/lateral_room.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace tractus::sketch {

DrawnAxis draw_axis(Rule const& rule, std::span<Vec3 const> nodes_mm)
{
    DrawnAxis axis;
    if (nodes_mm.empty())
        return axis;
    axis.base_mm = nodes_mm.front();
    AxisTurtle turtle(axis.base_mm);
    for (std::size_t i = 1; i < nodes_mm.size(); ++i) {
        auto const turn = turtle.turn_towards(nodes_mm[i] - nodes_mm[i - 1]);
        turtle.turn(turn);
        axis.turns.push_back({ rounded_as_text(turn.plane_deg), rounded_as_text(turn.bend_deg) });
    }
    axis.depth = depth_within_limit(rule, axis.segments());
    if (rule.occupancy_radius_mm > 0 && rule.laterals > 0)
        axis.room = lateral_room(rule, nodes_mm, axis.turns);
    return axis;
}

DrawnAxis aim_axis(SegmentLengths const& lengths, std::span<Vec3 const> nodes_mm)
{
    DrawnAxis axis;
    if (nodes_mm.empty())
        return axis;
    axis.base_mm = nodes_mm.front();
    AxisTurtle turtle(axis.base_mm);
    double length_mm = lengths.first_mm.front();
    for (std::size_t i = 1; i < nodes_mm.size(); ++i) {
        auto const exact = turtle.turn_towards(nodes_mm[i] - turtle.position_mm());
        Turn const turn { rounded_as_text(exact.plane_deg), rounded_as_text(exact.bend_deg) };
        turtle.turn(turn);
        turtle.go(length_mm);
        axis.turns.push_back(turn);
        length_mm = length_after(lengths, i - 1, length_mm);
    }
    return axis;
}

std::vector<Vec3> nodes_of(DrawnAxis const& axis, SegmentLengths const& lengths)
{
    std::vector<Vec3> nodes_mm { axis.base_mm };
    AxisTurtle turtle(axis.base_mm);
    double length_mm = lengths.first_mm.front();
    for (std::size_t i = 0; i < axis.turns.size(); ++i) {
        turtle.turn(axis.turns[i]);
        nodes_mm.push_back(turtle.go(length_mm));
        length_mm = length_after(lengths, i, length_mm);
    }
    return nodes_mm;
}

std::vector<Vec3> nodes_of(DrawnAxis const& axis, Rule const& rule)
{
    return nodes_of(axis, lengths_of(rule));
}

std::string array_of(std::vector<Turn> const& turns, double Turn::*angle_deg)
{
    std::string text;
    for (auto const& turn : turns)
        text += fmt::format("{}{:g}", text.empty() ? "" : ", ", turn.*angle_deg);
    return fmt::format("{{{}}}", text);
}

// A ring of laterals in the model's text. Rings of level 0 are on the drawn axis; rings of higher
// levels are on laterals that are axes themselves.
struct Ring {
    int laterals = 0;
    std::string ending {}; // Suffix of the names of the ring's definitions, such as "_A".
    // Beginning of the laterals' apex module, up to the length argument: "L(" or "A(0, ".
    std::string apex {};
    bool gives_way = false; // True if the model's array `room` limits the laterals' lengths.
};

// The letter of the module for the apex of lateral rule `level`. Letters of turtle commands and of
// the model's other modules are not used.
static std::string letter_of(std::size_t level)
{
    constexpr std::string_view kLetters = "ABCDEHIJ";
    static_assert(kLetters.size() == kMaxLateralRules);
    return std::string(kLetters.substr(level - 1, 1));
}

static Ring ring_at(Rule const& rule, std::size_t level)
{
    auto const levels = rule.lateral_rules.size();
    Ring ring { .laterals = rule.laterals, .apex = "L(" };
    std::size_t next = 0;
    if (level > 0) {
        ring.laterals = rule.lateral_rules[level - 1].laterals;
        ring.ending = "_" + letter_of(level);
        next = lateral_rule_after(rule, level - 1);
    }
    if (next < levels)
        ring.apex = letter_of(next + 1) + "(0, ";
    return ring;
}

// The ring at the end of a lateral that forks, as in Ijiri et al. 2006.
static Ring fork_of(Rule const& rule)
{
    auto ring = ring_at(rule, rule.lateral_rules.size());
    ring.apex = "L(";
    return ring;
}

// The model text of a node's laterals. `twist` and `depth` are expressions for the ring's azimuth
// and for how often its laterals may still fork.
static std::string text_of(Ring const& ring, std::string_view twist, std::string_view depth)
{
    std::string text;
    for (int i = 0; i < ring.laterals; ++i)
        text += fmt::format("\n        [/({0} + {1:g})+(ANGLE{2}){3}l * LATERAL{2}{5}, "
                            "w * LATERAL_WIDTH{2}, {4})]",
                            twist, 360.0 * i / ring.laterals, ring.ending, ring.apex, depth,
                            ring.gives_way ? fmt::format(" * room[{} * i + {}]", ring.laterals, i)
                                           : std::string());
    return text;
}

static std::string definitions(Rule const& rule, DrawnAxis const& axis)
{
    return fmt::format(
        "#define SEGMENTS      {}    /* of the stroke; fewer steps: the plant of its beginning */\n"
        "#define LENGTH        {:g}    /* of the first internode, cm, 5 to 100 */\n"
        "#define TOP           {:g}    /* an internode's length by the one before it, 0.5 to 1.2 "
        "*/\n"
        "#define WIDTH         {:g}    /* of the first internode, cm */\n"
        "#define TOP_WIDTH     {:g}    /* an internode's width by the one before it, 0.3 to 1 */\n"
        "#define ANGLE         {:g}    /* between a lateral and its parent, 0 to 150 */\n"
        "#define LATERAL       {:g}    /* a lateral's length by its parent's, 0.2 to 1 */\n"
        "#define LATERAL_WIDTH {:g}    /* a lateral's width by its parent's, 0.2 to 1 */\n"
        "#define TWIST         {:g}    /* from node to node of the stroke, -180 to 180 */\n"
        "#define LATERAL_TWIST {:g}    /* from node to node of laterals, -180 to 180 */\n"
        "#define SHORTEST      {:g}    /* a lateral that would be shorter rests, cm */\n"
        "#define DEPTH         {}    /* how often laterals may fork */\n",
        axis.segments(), rule.first_length_mm, rule.length_ratio, rule.first_width_mm,
        rule.width_ratio, rule.angle_deg, rule.lateral_length, rule.lateral_width,
        rule.axis_twist_deg, rule.lateral_twist_deg, rule.shortest_mm, axis.depth);
}

// The #define lines of laterals that are axes themselves.
static std::string lateral_definitions(Rule const& rule)
{
    std::string text;
    for (std::size_t level = 1; level <= rule.lateral_rules.size(); ++level) {
        auto const& lateral = rule.lateral_rules[level - 1];
        text += fmt::format("/* Laterals {0}, each an axis of its own. */\n"
                            "#define TOP_{0}           {1:g}\n"
                            "#define TOP_WIDTH_{0}     {2:g}\n"
                            "#define ANGLE_{0}         {3:g}\n"
                            "#define LATERAL_{0}       {4:g}\n"
                            "#define LATERAL_WIDTH_{0} {5:g}\n"
                            "#define TWIST_{0}         {6:g}\n"
                            "#define SHORTEST_{0}      {7:g}\n",
                            letter_of(level), lateral.length_ratio, lateral.width_ratio,
                            lateral.angle_deg, lateral.lateral_length, lateral.lateral_width,
                            lateral.twist_deg, lateral.shortest_mm);
    }
    return text;
}

// The array `room` of the model's text: for each lateral, the share of its length for which it has
// room. Returns an empty string if laterals do not give way.
static std::string array_of_room(DrawnAxis const& axis)
{
    std::string text;
    for (double const room : axis.room)
        text += fmt::format("{}{:g}", text.empty() ? "" : ", ", room);
    return text.empty()
        ? text
        : fmt::format("\n          array room[{}] = {{{}}};", axis.room.size(), text);
}

// The arrays of the model's text: planes and bends of the turns, and the laterals' room. An axis
// without segments gets arrays of one zero, because cpfg does not allow empty arrays.
static std::string arrays_of(DrawnAxis const& axis)
{
    if (axis.turns.empty())
        return "define: { array plane[1] = {0}; array bend[1] = {0}; }\n";
    return fmt::format("define: {{ array plane[SEGMENTS] = {};\n"
                       "          array bend[SEGMENTS] = {};{} }}\n",
                       array_of(axis.turns, &Turn::plane_deg),
                       array_of(axis.turns, &Turn::bend_deg), array_of_room(axis));
}

// The production of a lateral that is an axis itself: an internode, a ring of laterals and the next
// apex.
static std::string lateral_rule_of(Rule const& rule, std::size_t level)
{
    auto const letter = letter_of(level);
    return fmt::format(
        "/* The apex of laterals {0}. */\n"
        "{0}(i, l, w, d) : l >= SHORTEST_{0} && d > 0\n"
        "    --> !(w)F(l){1}\n"
        "        {0}(i + 1, l * TOP_{0}, w * TOP_WIDTH_{0}, d - 1)\n"
        "{0}(i, l, w, d) : * --> {0}(i, l, w, d)\n"
        "\n",
        letter, text_of(ring_at(rule, level), fmt::format("TWIST_{} * (i + 1)", letter), "d - 1"));
}

static std::string rules_of(Rule const& rule, DrawnAxis const& axis)
{
    auto ring = ring_at(rule, 0);
    ring.gives_way = !axis.room.empty();
    auto const fork = fork_of(rule);
    auto text = fmt::format(
        "/* The top apex: segment i of the stroke, its laterals, and the next top apex. */\n"
        "T(i, l, w) : i < SEGMENTS\n"
        "    --> /(plane[i])+(bend[i])\\(plane[i])!(w)F(l){}\n"
        "        T(i + 1, l * TOP, w * TOP_WIDTH)\n"
        "T(i, l, w) : * --> T(i, l, w)\n"
        "\n",
        text_of(ring, "TWIST * (i + 1)", "DEPTH"));
    for (std::size_t level = 1; level <= rule.lateral_rules.size(); ++level)
        text += lateral_rule_of(rule, level);
    return text
        + fmt::format("/* A lateral apex: an internode and laterals of its own. */\n"
                      "L(l, w, d) : l >= SHORTEST{} && d > 0\n"
                      "    --> !(w)F(l){}\n"
                      "L(l, w, d) : * --> L(l, w, d)\n",
                      fork.ending,
                      text_of(fork, fork.ending.empty() ? "LATERAL_TWIST" : "TWIST" + fork.ending,
                              "d - 1"));
}

// The homomorphism rules for leaves. All leaves of a plant have the same length. Lateral rules that
// refer to each other (laterals_by) end in finer twigs, so the leaves are then smaller.
static std::string leaves_of(Rule const& rule)
{
    bool const is_fine = std::ranges::any_of(rule.lateral_rules, &LateralRule::laterals_by);
    double const length
        = rounded_as_text(std::clamp(rule.first_length_mm / (is_fine ? 15 : 5), 2.0, 12.0));
    auto text = fmt::format("\nhomomorphism\n"
                            "L(l, w, d) --> ~l({0:g})\n"
                            "T(i, l, w) --> ~l({0:g})\n",
                            length);
    for (std::size_t level = 1; level <= rule.lateral_rules.size(); ++level)
        text += fmt::format("{}(i, l, w, d) --> ~l({:g})\n", letter_of(level), length);
    return text;
}

static constexpr std::string_view kView
    = "angle increment: 45\n"
      "initial line width: 1\n"
      "initial color: 1\n"
      "material: 1 bark kind=bark color=0.42,0.34,0.26 roughness=0.9\n"
      "material: 2 leaf kind=leaf color=0.30,0.48,0.18 roughness=0.5 translucency=0.4\n"
      "organ: l leaf kind=blade material=2 length=1 width=0.5 petiole=0 widest=0.45 tip=0.7 "
      "base=0.5 fold=14 curl=20\n";

lsystem::ModelSource write_model(Rule const& rule, DrawnAxis const& axis, Leaves leaves,
                                 std::string const& name)
{
    auto const text
        = fmt::format("/* A plant that grew along a stroke: the axis is as it was drawn. */\n"
                      "{}{}\n"
                      "Lsystem: 1\n"
                      "derivation length: SEGMENTS\n"
                      "{}"
                      "Axiom: T(0, LENGTH, WIDTH)\n"
                      "\n"
                      "{}"
                      "{}"
                      "endlsystem\n",
                      definitions(rule, axis), lateral_definitions(rule), arrays_of(axis),
                      rules_of(rule, axis), leaves == Leaves::Leafy ? leaves_of(rule) : "");
    return {
        .name = name + ".l", .text = text, .view_name = name + ".v", .view_text = std::string(kView)
    };
}

} // namespace tractus::sketch
