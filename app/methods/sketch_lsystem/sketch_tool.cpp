#include "app/methods/sketch_lsystem/sketch_tool.h"

#include "app/methods/sketch_lsystem/shorten_sketch_tool.h"
#include "app/methods/sketch_lsystem/sketch_previewer.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/scene/paper.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tractus {

namespace {

// Words in the order of the tool's values, of which the first is what no word means.
constexpr std::array<OptionWord, 2> kLeavesWords { {
    { "leafy", "Leaves" },
    { "bare", "Bare" },
} };
constexpr std::array<OptionWord, 3> kSurfaceWords { {
    { "as_it_moves", "As it moves" },
    { "space", "In space" },
    { "paper", "On paper" },
} };
constexpr std::array<OptionWord, 4> kPlaceWords { {
    { "ground", "Alone" },
    { "branch", "On a branch", "A rule grows along the stroke, on the branch where it begins" },
    { "in_place", "In its place", "A rule grows in the place of the branch" },
    { "change", "Change", nullptr, true },
} };

constexpr std::array<OptionWord, 6> kCardWords { {
    { "opposite", "Opposite" },
    { "whorls", "Whorls" },
    { "crown", "Crown" },
    { "vase", "Vase" },
    { "spire", "Spire" },
    { "fern", "Fern" },
} };

// What a ready rule is made of, in the order of the words.
struct RuleCard {
    double laterals;
    double angle_deg;
    double first_length_mm;
    double length_ratio;
    double lateral_length;
    double shortest_mm;
    std::optional<double> twist_deg {}; // No value: rings of laterals alternate.
};
constexpr std::array<RuleCard, 6> kCards { {
    { 2, 45, 30, 0.9, 0.62, 1 },
    { 4, 75, 28, 0.88, 0.62, 4 },
    { 5, 35, 60, 0.75, 0.7, 12 },
    { 2, 26, 45, 0.8, 0.8, 8 },
    { 6, 60, 14, 0.96, 0.7, 6 },
    { 2, 55, 13, 0.96, 0.7, 3, 0.0 }, // All in one plane.
} };

RuleCard const& card_of(SketchTool const& tool)
{
    return kCards[static_cast<std::size_t>(tool.card)];
}

void take_numbers_of_card(void* options)
{
    auto& tool = *static_cast<SketchTool*>(options);
    auto const& card = card_of(tool);
    tool.laterals = card.laterals;
    tool.angle_deg = card.angle_deg;
    tool.first_length_mm = card.first_length_mm;
    tool.length_ratio = card.length_ratio;
    tool.lateral_length = card.lateral_length;
}

void visit(OptionVisitor& visitor, SketchTool& tool)
{
    visitor.choice({ .words = kCardWords,
                     .offered = WordOption::Offered::InTurn,
                     .goes_with = take_numbers_of_card,
                     .label = "Rule" },
                   tool.card);
    visitor.number({ "laterals", "", 0, 8, 1, "Laterals" }, tool.laterals);
    visitor.number({ "angle", "degrees", 0, 150, 5, "Angle" }, tool.angle_deg);
    visitor.number({ "first", "mm", 5, 100, 5, "Internode" }, tool.first_length_mm);
    visitor.number({ "ratio", "", 0.5, 1.2, 0.05, "Lengthening" }, tool.length_ratio);
    visitor.number({ "lateral", "", 0.2, 1, 0.02, "Lateral" }, tool.lateral_length);
    int leaves = tool.leaves == sketch::Leaves::Leafy ? 0 : 1;
    visitor.word({ kLeavesWords }, leaves);
    tool.leaves = leaves == 0 ? sketch::Leaves::Leafy : sketch::Leaves::Bare;
    int surface = tool.surface == StrokeSurface::Decided ? 0
        : tool.surface == StrokeSurface::Space           ? 1
                                                         : 2;
    visitor.word({ kSurfaceWords }, surface);
    tool.surface = surface == 0 ? StrokeSurface::Decided
        : surface == 1          ? StrokeSurface::Space
                                : StrokeSurface::Paper;
    visitor.choice({ kPlaceWords }, tool.place);
}

bool is_on_branch(SketchTool const& tool)
{
    return tool.place == SketchTool::Place::Branch || tool.place == SketchTool::Place::InPlace;
}

// Returns the rule of a rule file that says no more.
sketch::Rule rule_of(SketchTool const& tool)
{
    constexpr double kSlender = 0.15;
    sketch::Rule rule;
    rule.laterals = static_cast<int>(tool.laterals + 0.5);
    rule.angle_deg = tool.angle_deg;
    rule.first_length_mm = tool.first_length_mm;
    rule.first_width_mm = kSlender * tool.first_length_mm;
    rule.length_ratio = tool.length_ratio;
    rule.lateral_length = tool.lateral_length;
    auto const& card = card_of(tool);
    rule.shortest_mm = card.shortest_mm;
    double const twist_deg = card.twist_deg.value_or(rule.laterals > 0 ? 180.0 / rule.laterals : 0);
    rule.axis_twist_deg = twist_deg;
    rule.lateral_twist_deg = twist_deg;
    return rule;
}

// What the buttons do not set stays as it was.
Result<std::vector<Edit>> change(SketchTool const& tool, Scene const& scene)
{
    auto const grown = sketch::newest_grown(*scene.drawn);
    if (!grown)
        return fail(Fault::User,
                    "the plant that takes what is drawn has not grown along a stroke: choose one "
                    "that has, or draw one");
    auto rule = grown->sketch->rule;
    auto const wanted = rule_of(tool);
    rule.laterals = wanted.laterals;
    rule.angle_deg = wanted.angle_deg;
    rule.first_length_mm = wanted.first_length_mm;
    rule.first_width_mm = wanted.first_width_mm;
    rule.length_ratio = wanted.length_ratio;
    rule.lateral_length = wanted.lateral_length;
    rule.axis_twist_deg = wanted.axis_twist_deg;
    rule.lateral_twist_deg = wanted.lateral_twist_deg;
    if (tool.card != SketchTool::Card::Opposite) // The first is what a tool without any has.
        rule.shortest_mm = wanted.shortest_mm;
    return std::vector<Edit> { sketch::ChangeSketch { scene.drawn->id, grown->part, rule,
                                                      tool.leaves } };
}

Result<std::vector<Edit>> grow(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    auto const& options = *tool.get<SketchTool>();
    if (options.place == SketchTool::Place::Change)
        return change(options, scene);
    auto grown = grown_along(options, stroke, scene);
    auto const place = TRY(place_of(options, grown, scene));
    if (!place)
        return std::vector<Edit> { std::move(grown) };
    fit_to_branch(grown, *place);
    std::vector<Edit> edits { std::move(grown) };
    for (auto& edit : graft_edits(scene, *place, 0))
        edits.push_back(std::move(edit));
    return edits;
}

} // namespace

sketch::GrowAlongStroke grown_along(SketchTool const& tool, Stroke const& stroke,
                                    Scene const& scene)
{
    sketch::GrowAlongStroke edit;
    edit.rule = rule_of(tool);
    edit.stroke = stroke;
    // What begins on a branch begins where the pad shows that: in space, however the surface moves.
    edit.surface = is_on_branch(tool) && tool.surface == StrokeSurface::Decided
        ? StrokeSurface::Space
        : decide_surface(stroke.tips, tool.surface);
    edit.leaves = tool.leaves;
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    return edit;
}

void fit_to_branch(sketch::GrowAlongStroke& grown, BranchPlace const& place)
{
    constexpr double kThinner = 0.85;  // Than what bears it.
    constexpr double kThinnest = 0.02; // Of a first internode's length.
    auto& rule = grown.rule;
    rule.first_width_mm
        = std::clamp(kThinner * place.diameter_mm, kThinnest * rule.first_length_mm,
                     std::max(rule.first_width_mm, kThinnest * rule.first_length_mm));
}

Result<std::optional<BranchPlace>>
place_of(SketchTool const& tool, sketch::GrowAlongStroke const& grown, Scene const& scene)
{
    if (!is_on_branch(tool) || grown.stroke.tips.empty())
        return std::nullopt;
    Vec3 const down_mm = grown.stroke.tips.front().position_mm;
    auto const grafting
        = tool.place == SketchTool::Place::InPlace ? Grafting::InPlace : Grafting::Beside;
    if (grown.surface == StrokeSurface::Paper)
        return TRY(branch_at(scene, paper_of(scene.state).world_of_sheet(down_mm.head<2>()),
                             Vec3::UnitY(), grafting));
    return TRY(branch_at(scene, down_mm, Vec3::UnitZ(), grafting));
}

constexpr ToolKind SketchTool::kKind {
    .word = "sketch",
    .label = "Rule",
    .title = "A rule grows along the stroke",
    .done = "A plant has grown along the stroke",
    .help = "adds a plant: a rule grows along the stroke, a ready one or with so many laterals at "
            "an angle in "
            "degrees, a first internode of so many mm, the next ones and laterals by ratios; with "
            "leaves or bare; as drawn in space, on paper that stands upright, or whichever the "
            "surface's way shows; alone, on the branch where the stroke begins, or in its place; "
            "or at once these "
            "numbers for what has grown along a stroke last",
    .group = "Sketch",
    .method = "Along a stroke",
    .icon = "5950 5674 5422 5362",
    .key = 'K',
    .options = options_type<SketchTool, visit>(),
    .mean = grow,
    .previewer = sketch_previewer,
    .other_end = { &ShortenSketchTool::kKind },
};

} // namespace tractus
