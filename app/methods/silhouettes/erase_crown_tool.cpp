#include "app/methods/silhouettes/erase_crown_tool.h"

#include "app/methods/silhouettes/crown_tool.h"

#include <algorithm>

namespace tractus::silhouette {

namespace {

Result<std::vector<scene::Edit>> erase_lines(tools::Tool const&, Stroke const& stroke,
                                             scene::Scene const& scene)
{
    auto const* const tree = silhouette::outlined_tree(*scene.drawn);
    if (!tree || tree->crown_lines.empty())
        return fail(Fault::User,
                    "the plant that takes what is drawn has no crown in space: draw rings "
                    "around it first");
    auto const eraser = on_sheet(stroke, scene::paper_of(scene.state));
    std::vector<scene::Edit> edits;
    for (auto const& drawn : tree->crown_lines) {
        auto const line = TRY(silhouette::crown_line_of(drawn.stroke));
        bool const is_near
            = std::any_of(eraser.tips.begin(), eraser.tips.end(), [&](TipSample const& tip) {
                  return std::any_of(line.begin(), line.end(), [&](Vec3 const& point) {
                      return (point - tip.position_mm).norm() <= EraseCrownTool::kRadius_mm;
                  });
              });
        if (is_near)
            edits.push_back(silhouette::EraseTreePart {
                scene.drawn->id, silhouette::DrawTree::Part::Surface, drawn.id });
    }
    if (edits.empty())
        return fail(Fault::User,
                    "the eraser came near no line of the crown: move it over one in space");
    return edits;
}

} // namespace

constexpr tools::ToolKind EraseCrownTool::kKind {
    .word = "erase_crown",
    .label = "Erase in space",
    .title = "Erase lines of the crown in space",
    .done = "The line is erased",
    .help = "takes away lines in space of a tree's crown that the stroke comes near",
    .group = "Sketch",
    .method = "From an outline",
    .ink = { tools::InkStyle::Look::Eraser, 2 * EraseCrownTool::kRadius_mm },
    .options = tools::options_type<EraseCrownTool>(),
    .edits_for = erase_lines,
    .other_end = { &EraseCrownTool::kKind },
};

} // namespace tractus::silhouette
