#include "app/methods/sketch_lsystem/sketch_tool.h"

#include "app/methods/sketch_lsystem/sketch_previewer.h"
#include "app/tools/erase_tool.h"

#include <array>

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

void visit(OptionVisitor& visitor, SketchTool& tool)
{
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
    double const twist_deg = rule.laterals > 0 ? 180.0 / rule.laterals : 0;
    rule.axis_twist_deg = twist_deg;
    rule.lateral_twist_deg = twist_deg;
    return rule;
}

Result<std::vector<Edit>> grow(Tool const& tool, Stroke const& stroke, Scene const& scene)
{
    return std::vector<Edit> { grown_along(*tool.get<SketchTool>(), stroke, scene) };
}

} // namespace

sketch::GrowAlongStroke grown_along(SketchTool const& tool, Stroke const& stroke,
                                    Scene const& scene)
{
    sketch::GrowAlongStroke edit;
    edit.rule = rule_of(tool);
    edit.stroke = stroke;
    edit.surface = decide_surface(stroke.tips, tool.surface);
    edit.leaves = tool.leaves;
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    return edit;
}

constexpr ToolKind SketchTool::kKind {
    .word = "sketch",
    .label = "Rule",
    .title = "A rule grows along the stroke",
    .done = "A plant has grown along the stroke",
    .help = "adds a plant: a rule grows along the stroke, with so many laterals at an angle in "
            "degrees, a first internode of so many mm, the next ones and laterals by ratios; with "
            "leaves or bare; as drawn in space, on paper that stands upright, or whichever the "
            "surface's way shows",
    .group = "Sketch",
    .method = "Along a stroke",
    .icon = "5950 5674 5422 5362",
    .key = 'K',
    .options = options_type<SketchTool, visit>(),
    .mean = grow,
    .previewer = sketch_previewer,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus
