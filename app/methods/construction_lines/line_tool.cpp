#include "app/methods/construction_lines/line_tool.h"

#include "app/methods/construction_lines/erase_line_tool.h"
#include "app/methods/construction_lines/line_curves.h"
#include "app/methods/construction_lines/line_previewer.h"
#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/paper.h"

#include <array>
#include <cmath>

namespace tractus::lines {

namespace {

// Option words, in the order of LineTool::Plant.
constexpr std::array<tools::OptionWord, 3> kPlantWords { {
    { "go_on", "Line" },
    { "another_stem", "Another stem" },
    { "new_stem", "Another plant" },
} };
// Option words, in the order of Pattern::Kind.
constexpr std::array<tools::OptionWord, 5> kPatternWords { {
    { "distichous", "Two rows" },
    { "decussate", "Crossed pairs" },
    { "spiral", "Spiral" },
    { "alternate", "Alternate" },
    { "whorled", "Whorls" },
} };

// Option words, in the order of lines::DepthBy. Logs from before boundaries had depth lack this
// option and mean the first word.
constexpr std::array<tools::OptionWord, 3> kDepthWords { {
    { "stems_height", "height, stem" },
    { "height", "height" },
    { "pressure", "pressure, stem" },
} };

// Option words, in the order of lines::Reading. Logs from before lines were interpreted together
// lack this option and mean the first word.
constexpr std::array<tools::OptionWord, 2> kReadingWords { {
    { "one_by_one", "one by one" },
    { "together", "together" },
} };

void visit(tools::OptionVisitor& visitor, LineTool& tool)
{
    visitor.choice({ kPlantWords }, tool.plant);
    visitor.choice({ kPatternWords, tools::WordOption::Offered::InHand }, tool.pattern);
    visitor.choice(
        { .words = kDepthWords, .offered = tools::WordOption::Offered::InTurn, .label = "Depth" },
        tool.depth_by);
    visitor.choice(
        { .words = kReadingWords, .offered = tools::WordOption::Offered::InTurn, .label = "Read" },
        tool.reading);
    visitor.number({ "nodes", "", 0, lines::kMaxNodesInLayer, 1, "Nodes" }, tool.nodes);
    visitor.number({ "divergence", "degrees", -360, 360, 0.5, "Divergence" }, tool.divergence_deg);
    visitor.number({ "organs", "", 2, 24, 1, "Organs" }, tool.organs);
}

lines::Pattern pattern_of(LineTool const& tool)
{
    constexpr double kLeftAndRight_deg = 180;
    lines::Pattern pattern;
    pattern.kind = tool.pattern;
    pattern.divergence_deg
        = tool.pattern == lines::Pattern::Kind::Alternate ? kLeftAndRight_deg : tool.divergence_deg;
    pattern.whorl = static_cast<int>(std::lround(tool.organs));
    return pattern;
}

Result<std::vector<scene::Edit>> add_line(tools::Tool const& tool, Stroke const& stroke,
                                          scene::Scene const& scene)
{
    return std::vector<scene::Edit> { line_drawn(*tool.get<LineTool>(), stroke, scene) };
}

} // namespace

lines::AddLine line_drawn(LineTool const& tool, Stroke const& stroke, scene::Scene const& scene)
{
    lines::AddLine edit;
    edit.stroke = stroke;
    edit.depth_by = tool.depth_by;
    edit.reading = tool.reading;
    edit.nodes = static_cast<int>(std::lround(tool.nodes));
    edit.pattern = pattern_of(tool);
    if (tool.plant != LineTool::Plant::NewStem && lines::active_pen_sketch(scene.state)) {
        edit.plant = scene.state.active;
        edit.another_stem = tool.plant == LineTool::Plant::AnotherStem;
    }
    if (!scene.plants.empty())
        edit.scale = scene.placement.scale;
    if (!stroke.tips.empty()) {
        edit.stands_at_mm = scene::paper_of(scene.state)
                                .world_of_sheet(stroke.tips.front().position_mm.head<2>());
        edit.stands_at_mm.z() = 0;
    }
    return edit;
}

std::string describe_sketch(tools::Tool const&, scene::Scene const& after)
{
    auto const* const sketch = lines::active_pen_sketch(after.state);
    return sketch ? lines::describe_result(*sketch) : "";
}

constexpr tools::ToolKind LineTool::kKind {
    .word = "construction_line",
    .label = "Line",
    .title = "Draw a plant's construction lines",
    .done = "The plant follows the line",
    .help
    = "adds a line to a sketch of stem, boundaries and inclination lines, which a plant "
      "follows: the stem begins the plant, on the tablet as on paper that stands upright, "
      "and another_stem stands beside it, or on it where it begins there; a "
      "layer between two inclination lines has so many nodes, and a plant that begins has "
      "this pattern, with a divergence in degrees of spirals and so many organs of whorls; by "
      "the surface's height the stem has a depth and a boundary is in space, else the stem "
      "alone has one, or has it by the pen's pressure; lines are read together, so that pieces, "
      "corrections and outlines count, or one by one as they come",
    .group = "Sketch",
    .method = "From lines",
    .icon = "5951 292351 898351 245684",
    .key = 'I',
    .surface = tools::Surface::Paper,
    .min_extent_mm = 3,
    .makes = &kPenSketch,
    .options = tools::options_type<LineTool, visit>(),
    .drawn_gizmo = &kLineCurves,
    .edits_for = add_line,
    .describe = describe_sketch,
    .previewer = line_previewer,
    .other_end = { &EraseLineTool::kKind },
};

} // namespace tractus::lines
