#include "app/methods/construction_lines/layer_nodes_tool.h"

#include "app/methods/construction_lines/erase_line_tool.h"
#include "app/methods/construction_lines/touched_sketch.h"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tractus::lines {

namespace {

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 3> kWords { {
    { "touched", "Nodes of a layer" },
    { "more", "One node more", nullptr, true },
    { "fewer", "One fewer", nullptr, true },
} };

void visit(tools::OptionVisitor& visitor, LayerNodesTool& tool)
{
    visitor.choice({ kWords, tools::WordOption::Offered::InHand }, tool.what);
    visitor.number({ "count", "", 0, lines::kMaxNodesInLayer, 1, "Nodes" }, tool.nodes);
}

Result<std::vector<scene::Edit>> set_nodes(tools::Tool const& tool, Stroke const& stroke,
                                           scene::Scene const& scene)
{
    auto const& options = *tool.get<LayerNodesTool>();
    auto const active = TRY(active_sketch(scene));
    if (options.what == LayerNodesTool::What::Touched) {
        auto const layer = TRY(lines::layer_at(active.sketch, touched_mm(active, stroke)));
        return std::vector<scene::Edit> { lines::SetLayerNodes {
            active.plant, layer.line, static_cast<int>(std::lround(options.nodes)) } };
    }
    auto const topmost = TRY(lines::layers_of(active.sketch)).back();
    int const nodes = topmost.nodes + (options.what == LayerNodesTool::What::More ? 1 : -1);
    if (nodes < 0 || nodes > lines::kMaxNodesInLayer)
        return fail(Fault::User,
                    fmt::format("the topmost layer has {} nodes, and cannot have {}", topmost.nodes,
                                nodes < 0 ? "fewer" : "more"));
    return std::vector<scene::Edit> { lines::SetLayerNodes { active.plant, topmost.line, nodes } };
}

} // namespace

constexpr tools::ToolKind LayerNodesTool::kKind {
    .word = "layer_nodes",
    .label = "Nodes of a layer",
    .title = "Set the nodes of a layer",
    .done = "The layer has so many nodes now",
    .help
    = "gives the layer of a sketch beside which the stroke ends so many nodes, or the topmost "
      "one a node more or one fewer",
    .group = "Sketch",
    .method = "From lines",
    .begins_group_of_buttons = true,
    .surface = tools::Surface::Paper,
    .options = tools::options_type<LayerNodesTool, visit>(),
    .edits_for = set_nodes,
    .other_end = { &EraseLineTool::kKind },
};

} // namespace tractus::lines
