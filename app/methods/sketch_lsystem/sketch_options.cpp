#include "app/methods/sketch_lsystem/sketch_options.h"

#include "app/methods/sketch_lsystem/ready_models.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace tractus::sketch {

namespace {

// Option words, in the order of the tool's values. The first word is meant by logs that lack the
// option.
constexpr std::array<tools::OptionWord, 2> kLeavesOptions { {
    { "leafy", "Leaves" },
    { "bare", "Bare" },
} };
constexpr std::array<tools::OptionWord, 3> kSurfaceOptions { {
    { "as_it_moves", "as it moves" },
    { "space", "in space" },
    { "paper", "on paper" },
} };
constexpr std::array<tools::OptionWord, 6> kPlaceWords { {
    { "ground", "Alone" },
    { "branch", "On a branch", "A rule grows along the stroke, on the branch where it begins" },
    { "in_place", "In its place", "A rule grows in the place of the branch" },
    { "again", "Again", "The stroke of a plant is drawn again" },
    { "change", "Change", nullptr, true },
    { "turn_round", "Turn round", nullptr, true },
} };
constexpr std::array<tools::OptionWord, 2> kStandsWords { {
    { "at_beginning", "at the stroke's beginning" },
    { "at_foot", "at the stroke's foot" },
} };
constexpr std::array<tools::OptionWord, 2> kDrawnWords { {
    { "follow", "follows" },
    { "stay", "stays" },
} };
constexpr char const* kModelTitle = "The model grows along the stroke";
constexpr std::array<tools::OptionWord, 17> kCardWords { {
    { "opposite", "Opposite" },
    { "whorls", "Whorls" },
    { "crown", "Crown" },
    { "vase", "Vase" },
    { "spire", "Spire" },
    { "fern", "Fern" },
    { "herb", "Herb" },
    { "tufts", "Tufts" },
    { "compound_leaf", "Compound" },
    // The following words are the names of built-in models (ready_models.h).
    { "birch", "Birch", kModelTitle },
    { "broadleaf", "Broadleaf", kModelTitle },
    { "conifer", "Conifer", kModelTitle },
    { "frond", "Frond", kModelTitle },
    { "palm", "Palm", kModelTitle },
    { "poplar", "Poplar", kModelTitle },
    { "vine", "Vine", kModelTitle },
    { "as_plant", "The plant's", "The plant grows anew along the stroke" },
} };

// Option words, in the order of SketchTool::Laterals. Fork is the behaviour in the paper; the next
// words name the first presets.
constexpr std::array<tools::OptionWord, 8> kLateralsWords { {
    { "fork", "fork" },
    { "by_opposite", "as opposite" },
    { "by_whorls", "as whorls" },
    { "by_crown", "as a crown" },
    { "by_vase", "as a vase" },
    { "by_spire", "as a spire" },
    { "by_fern", "as a fern" },
    { "as_axis", "as the axis" },
} };

// Numbers of a rule that is a preset; kCards has them in the order of the presets.
struct RuleCard {
    double laterals;
    double angle_deg;
    double first_length_mm;
    double length_ratio;
    double lateral_length;
    double shortest_mm;
    // Twist from each ring of laterals to the next; no value: laterals of successive rings
    // alternate.
    std::optional<double> twist_deg {};
    bool goes_on = false; // The laterals grow by the same rule as the axis, at every level.
    double width_ratio = SketchTool().width_ratio;
};
constexpr std::array<RuleCard, 9> kCards { {
    { 2, 50, 15, 0.95, 0.7, 1 },
    { 4, 75, 28, 0.88, 0.62, 4 },
    { 5, 35, 60, 0.75, 0.7, 12 },
    { 2, 26, 45, 0.8, 0.8, 8 },
    { 6, 60, 14, 0.96, 0.7, 6 },
    { 2, 55, 13, 0.96, 0.7, 3, 0.0 }, // A fern: with twist 0, all branches are in one plane.
    { 1, 55, 20, 0.95, 0.6, 2, 137.5 },
    { 7, 60, 18, 1, 0.3, 4 },
    // The compound leaf of Prusinkiewicz and Lindenmayer (Ijiri 2006, figure 2): with each step,
    // internodes double in length. A lateral is the leaf with the number of steps that remain.
    { 2, 45, 60, 0.5, 0.5, 1, 0.0, true, 0.6 },
} };
// Diameter of the first internode as a share of its length, for all presets.
constexpr double kSlender = 0.15;

// True if the tool's preset is a model or a copy of the active plant; the tool's numbers then have
// no effect.
bool is_of_model(SketchTool const& tool)
{
    return static_cast<std::size_t>(tool.card) >= kCards.size();
}

// The rule of the tool's preset, or that of the first preset if the tool's preset is not a rule.
RuleCard const& ready_rule_of(SketchTool const& tool)
{
    return is_of_model(tool) ? kCards.front() : kCards[static_cast<std::size_t>(tool.card)];
}

void take_numbers_of_card(void* options)
{
    auto& tool = *static_cast<SketchTool*>(options);
    auto const& card = ready_rule_of(tool);
    SketchTool const plain;
    tool.laterals = card.laterals;
    tool.angle_deg = card.angle_deg;
    tool.first_length_mm = card.first_length_mm;
    tool.length_ratio = card.length_ratio;
    tool.lateral_length = card.lateral_length;
    tool.width_ratio = card.width_ratio;
    tool.lateral_width = plain.lateral_width;
    tool.axis_twist_deg = plain.axis_twist_deg;
    tool.lateral_twist_deg = plain.lateral_twist_deg;
    tool.shortest_mm = plain.shortest_mm;
    if (card.goes_on)
        tool.go_on_by = SketchTool::Laterals::AsAxis;
    else if (tool.go_on_by == SketchTool::Laterals::AsAxis)
        tool.go_on_by = plain.go_on_by;
}

double twist_of(RuleCard const& card, double laterals)
{
    return card.twist_deg.value_or(laterals > 0 ? 180 / laterals : 0);
}

// The twist of the tool's preset from node to node, to which the tool's twists are added.
double twist_of_card(SketchTool const& tool)
{
    return twist_of(ready_rule_of(tool), std::round(tool.laterals));
}

// Rules for the laterals on laterals; empty if laterals fork. Otherwise a single rule: that of a
// preset, whose shortest internode depends on the axis's first internode, or that of the axis,
// repeated at every level.
std::vector<sketch::LateralRule> lateral_rules_of(SketchTool const& tool, sketch::Rule const& axis)
{
    // Shortest internode of laterals, as a share of the axis's first internode.
    constexpr double kShortest = 0.1;
    if (tool.go_on_by == SketchTool::Laterals::Fork)
        return {};
    if (tool.go_on_by == SketchTool::Laterals::AsAxis)
        return { { .length_ratio = axis.length_ratio,
                   .width_ratio = axis.width_ratio,
                   .laterals = axis.laterals,
                   .angle_deg = axis.angle_deg,
                   .lateral_length = axis.lateral_length,
                   .lateral_width = axis.lateral_width,
                   .twist_deg = axis.lateral_twist_deg,
                   .shortest_mm = axis.shortest_mm,
                   .laterals_by = 1 } };
    auto const& card = kCards[static_cast<std::size_t>(tool.go_on_by) - 1];
    return { { .length_ratio = card.length_ratio,
               .laterals = static_cast<int>(card.laterals),
               .angle_deg = card.angle_deg,
               .lateral_length = card.lateral_length,
               .twist_deg = twist_of(card, card.laterals),
               .shortest_mm = kShortest * axis.first_length_mm } };
}

// The option with which the tool gives the lateral rules of `rule`; no value if there is none.
std::optional<SketchTool::Laterals> stated_laterals(SketchTool tool, sketch::Rule const& rule)
{
    for (std::size_t i = 0; i < kLateralsWords.size(); ++i) {
        tool.go_on_by = static_cast<SketchTool::Laterals>(i);
        if (lateral_rules_of(tool, rule) == rule.lateral_rules)
            return tool.go_on_by;
    }
    return std::nullopt;
}

} // namespace

void visit_sketch_options(tools::OptionVisitor& visitor, SketchTool& tool)
{
    visitor.choice({ .words = kCardWords,
                     .offered = tools::WordOption::Offered::Cards,
                     .goes_with = take_numbers_of_card,
                     .label = "Rule" },
                   tool.card);
    using enum tools::NumberOption::Offered;
    visitor.number({ "laterals", "", 0, 8, 1, "Laterals", WithoutGizmo }, tool.laterals);
    visitor.number({ "angle", "degrees", 0, 150, 5, "Angle", WithoutGizmo, 45 }, tool.angle_deg);
    visitor.number({ "first", "mm", 5, 100, 5, "Internode", Always, 30 }, tool.first_length_mm);
    visitor.number({ "ratio", "", 0.5, 1.2, 0.05, "Lengthening", WithoutGizmo, 0.9 },
                   tool.length_ratio);
    visitor.number({ "lateral", "", 0.2, 1, 0.02, "Lateral", WithoutGizmo, 0.62 },
                   tool.lateral_length);
    visitor.choice({ .words = kLateralsWords,
                     .offered = tools::WordOption::Offered::InTurn,
                     .label = "Laterals" },
                   tool.go_on_by);
    int leaves = tool.leaves == sketch::Leaves::Leafy ? 0 : 1;
    visitor.word({ kLeavesOptions }, leaves);
    tool.leaves = leaves == 0 ? sketch::Leaves::Leafy : sketch::Leaves::Bare;
    int surface = tool.surface == StrokeSurface::Decided ? 0
        : tool.surface == StrokeSurface::Space           ? 1
                                                         : 2;
    visitor.word({ .words = kSurfaceOptions,
                   .offered = tools::WordOption::Offered::InTurn,
                   .label = "Surface" },
                 surface);
    tool.surface = surface == 0 ? StrokeSurface::Decided
        : surface == 1          ? StrokeSurface::Space
                                : StrokeSurface::Paper;
    visitor.choice({ kPlaceWords }, tool.place);
    visitor.choice({ .words = kDrawnWords,
                     .offered = tools::WordOption::Offered::BesideGizmo,
                     .label = "Drawn" },
                   tool.drawn);
    visitor.number({ "width", "", 0.3, 1, 0.05, "Thinning", OnGizmo }, tool.width_ratio);
    visitor.number({ "lateral_width", "", 0.2, 1, 0.05, "Lateral's thickness", OnGizmo },
                   tool.lateral_width);
    visitor.number({ "twist", "degrees", -180, 180, 5, "Twist beyond the rule's", OnGizmo },
                   tool.axis_twist_deg);
    visitor.number(
        { "lateral_twist", "degrees", -180, 180, 5, "Laterals' twist beyond the rule's", OnGizmo },
        tool.lateral_twist_deg);
    visitor.number({ "shortest", "mm", 0, 100, 1, "Shortest internode, 0: the rule's", OnGizmo },
                   tool.shortest_mm);
    visitor.number({ "room", "mm", 0, 50, 1, "Gives way within, 0: not", OnGizmo }, tool.room_mm);
    visitor.choice(
        { .words = kStandsWords, .offered = tools::WordOption::Offered::InTurn, .label = "Stands" },
        tool.stands);
}

sketch::ModelRule model_of(SketchTool const& tool)
{
    if (!is_of_model(tool) || tool.card == SketchTool::Card::Plant)
        return {};
    return ready_model(kCardWords[static_cast<std::size_t>(tool.card)].word);
}

sketch::Rule rule_of(SketchTool const& tool)
{
    sketch::Rule rule;
    if (is_of_model(tool))
        return rule;
    rule.laterals = static_cast<int>(std::round(tool.laterals));
    rule.angle_deg = tool.angle_deg;
    rule.first_length_mm = tool.first_length_mm;
    rule.first_width_mm = kSlender * tool.first_length_mm;
    rule.length_ratio = tool.length_ratio;
    rule.width_ratio = tool.width_ratio;
    rule.lateral_length = tool.lateral_length;
    rule.lateral_width = tool.lateral_width;
    rule.shortest_mm = tool.shortest_mm > 0 ? tool.shortest_mm : ready_rule_of(tool).shortest_mm;
    double const twist_deg = twist_of_card(tool);
    rule.axis_twist_deg = wrap_angle_deg(twist_deg + tool.axis_twist_deg);
    rule.lateral_twist_deg = wrap_angle_deg(twist_deg + tool.lateral_twist_deg);
    rule.lateral_rules = lateral_rules_of(tool, rule);
    rule.occupancy_radius_mm = tool.room_mm;
    return rule;
}

sketch::Rule with_options(sketch::Rule const& rule, SketchTool const& tool)
{
    auto wanted = rule_of(tool);
    double const slender = rule.first_width_mm / rule.first_length_mm;
    if (slender < kSlender)
        wanted.first_width_mm = slender * wanted.first_length_mm;
    // Lateral rules from a file, which no option can express, are kept until an option replaces
    // them.
    if (wanted.lateral_rules.empty() && !stated_laterals(tool, rule))
        wanted.lateral_rules = rule.lateral_rules;
    wanted.most_segments = rule.most_segments;
    wanted.most_internodes = rule.most_internodes;
    return wanted;
}

bool matches_rule(SketchTool const& tool, sketch::Rule const& rule)
{
    // Tolerance for comparing numbers that were computed in two ways.
    constexpr double kSame = 1e-6;
    auto const said = rule_of(tool);
    auto const is_same = [](double one, double other) { return std::abs(one - other) < kSame; };
    return said.laterals == rule.laterals && is_same(said.angle_deg, rule.angle_deg)
        && is_same(said.first_length_mm, rule.first_length_mm)
        && is_same(said.length_ratio, rule.length_ratio)
        && is_same(said.width_ratio, rule.width_ratio)
        && is_same(said.lateral_length, rule.lateral_length)
        && is_same(said.lateral_width, rule.lateral_width)
        && is_same(wrap_angle_deg(said.axis_twist_deg - rule.axis_twist_deg), 0)
        && is_same(wrap_angle_deg(said.lateral_twist_deg - rule.lateral_twist_deg), 0)
        && is_same(said.shortest_mm, rule.shortest_mm)
        && is_same(said.occupancy_radius_mm, rule.occupancy_radius_mm)
        && (said.lateral_rules == rule.lateral_rules || !stated_laterals(tool, rule));
}

bool matches_sketch(SketchTool const& tool, sketch::GrowAlongStroke const& grown)
{
    if (tool.card == SketchTool::Card::Plant)
        return false;
    if (is_of_model(tool) || grown.model.is_set())
        return grown.model.source == model_of(tool).source;
    return matches_rule(tool, grown.rule);
}

SketchTool with_options_of_sketch(SketchTool const& tool, sketch::GrowAlongStroke const& grown)
{
    auto said = tool;
    if (!grown.model.is_set()) {
        if (is_of_model(said))
            said.card = SketchTool::Card::Opposite;
        return with_options_of_rule(said, grown.rule);
    }
    for (auto card = kCards.size(); card < kCardWords.size(); ++card) {
        said.card = static_cast<SketchTool::Card>(card);
        if (matches_sketch(said, grown))
            return said;
    }
    // No model of a preset fits, so the last preset is used, which copies the active plant.
    return said;
}

SketchTool with_options_of_rule(SketchTool tool, sketch::Rule const& rule)
{
    tool.laterals = rule.laterals;
    tool.angle_deg = rule.angle_deg;
    tool.first_length_mm = rule.first_length_mm;
    tool.length_ratio = rule.length_ratio;
    tool.width_ratio = rule.width_ratio;
    tool.lateral_length = rule.lateral_length;
    tool.lateral_width = rule.lateral_width;
    tool.go_on_by = stated_laterals(tool, rule).value_or(SketchTool::Laterals::Fork);
    double const twist_deg = twist_of_card(tool);
    tool.axis_twist_deg = wrap_angle_deg(rule.axis_twist_deg - twist_deg);
    tool.lateral_twist_deg = wrap_angle_deg(rule.lateral_twist_deg - twist_deg);
    tool.room_mm = rule.occupancy_radius_mm;
    tool.shortest_mm = rule.shortest_mm == ready_rule_of(tool).shortest_mm ? 0 : rule.shortest_mm;
    return tool;
}

// An angle that is already in the range is returned unchanged, to the last bit.
double wrap_angle_deg(double angle_deg)
{
    return std::abs(angle_deg) <= 180 ? angle_deg : std::remainder(angle_deg, 360);
}

} // namespace tractus::sketch
