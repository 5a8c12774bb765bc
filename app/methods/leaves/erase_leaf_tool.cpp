#include "app/methods/leaves/erase_leaf_tool.h"

#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"

#include <algorithm>

namespace tractus::leaf {

namespace {

bool runs_over(Stroke const& eraser, leaf::FlatLine const& line)
{
    return std::any_of(eraser.tips.begin(), eraser.tips.end(), [&](TipSample const& tip) {
        return leaf::nearest_on(line, tip.position_mm.head<2>()).distance
            <= EraseLeafTool::kRadius_mm;
    });
}

leaf::FlatLine flat(std::vector<Vec3> const& line)
{
    leaf::FlatLine made;
    for (auto const& point : line)
        made.emplace_back(point.head<2>());
    return made;
}

// Erases the drawing's lines under the eraser. The last line of a leaf cannot be erased; the edit
// RemovePlant removes the whole leaf instead.
Result<std::vector<scene::Edit>> erase(tools::Tool const&, Stroke const& stroke,
                                       scene::Scene const& scene)
{
    auto const* const sketch = leaf::active_leaf_sketch(scene.state);
    if (!sketch)
        return fail(Fault::User,
                    "the plant that takes what is drawn is no drawn leaf: choose one, or draw one");
    auto const drawing = TRY(leaf::drawing_of(*sketch));
    std::vector<scene::Edit> edits;
    for (std::size_t i = 0; i < drawing.strokes.size(); ++i)
        if (runs_over(stroke, flat(drawing.strokes[i])))
            edits.push_back(leaf::EraseLeafLine { scene.state.active, sketch->lines[i].id });
    if (edits.empty())
        return fail(Fault::User,
                    "the eraser touched nothing of the leaf: move it over a line of its drawing");
    return edits;
}

} // namespace

constexpr tools::ToolKind EraseLeafTool::kKind {
    .word = "erase_leaf",
    .label = "Erase",
    .title = "Erase lines of the leaf's drawing",
    .done = "The line is erased",
    .help = "takes away the lines of a drawn leaf that the stroke runs over on paper",
    .group = "Sketch",
    .method = "A leaf",
    .surface = tools::Surface::Paper,
    .ink = { tools::InkStyle::Look::Eraser, 2 * EraseLeafTool::kRadius_mm },
    .options = tools::options_type<EraseLeafTool>(),
    .edits_for = erase,
    .other_end = { &EraseLeafTool::kKind },
};

} // namespace tractus::leaf
