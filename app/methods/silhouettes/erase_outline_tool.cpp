#include "app/methods/silhouettes/erase_outline_tool.h"

#include "engine/methods/silhouettes/tree_edits.h"

#include <algorithm>

namespace tractus::silhouette {

namespace {

using silhouette::BumpTouch;
using silhouette::DrawTree;
using silhouette::EraseTreePart;

bool runs_over(Stroke const& eraser, std::vector<Vec2> const& line)
{
    if (line.empty())
        return false;
    return std::any_of(eraser.tips.begin(), eraser.tips.end(), [&](TipSample const& tip) {
        return silhouette::distance_to_line(tip.position_mm.head<2>(), line)
            <= EraseOutlineTool::kRadius_mm;
    });
}

// Erases only the smallest of the touched lines, which the user most likely means: a touch on a
// bump before a branch, a branch before its parent, and a branch's outline before that of the
// crown.
Result<std::vector<scene::Edit>> erase(tools::Tool const&, Stroke const& stroke,
                                       scene::Scene const& scene)
{
    auto const* const tree = silhouette::outlined_tree(*scene.drawn);
    if (!tree)
        return fail(Fault::User,
                    "the plant that takes what is drawn has no outline: choose a tree that was "
                    "drawn by its outline");
    auto as_drawn = *tree;
    as_drawn.trunk_goes_on_mm = 0;
    auto const drawing = TRY(silhouette::drawing_of(as_drawn));
    auto const plant = scene.drawn->id;
    std::vector<scene::Edit> edits;
    for (std::size_t i = 0; i < drawing.touches.size(); ++i)
        if (runs_over(stroke, { drawing.touches[i].place }))
            edits.push_back(EraseTreePart { plant,
                                            tree->touches[i].kind == BumpTouch::Kind::Split
                                                ? DrawTree::Part::Split
                                                : DrawTree::Part::Join,
                                            tree->touches[i].id });
    if (!edits.empty())
        return edits;
    for (std::size_t i = 0; i < drawing.own_branches.size(); ++i)
        if (runs_over(stroke, drawing.own_branches[i].line))
            edits.push_back(
                EraseTreePart { plant, DrawTree::Part::OwnBranch, tree->own_branches[i].id });
    if (!edits.empty())
        return edits;
    for (std::size_t i = 0; i < drawing.branches.size(); ++i)
        if (runs_over(stroke, drawing.branches[i]))
            edits.push_back(EraseTreePart { plant, DrawTree::Part::Branch, tree->branches[i].id });
    for (std::size_t i = 0; i < drawing.own_outlines.size() && edits.empty(); ++i)
        if (runs_over(stroke, drawing.own_outlines[i].outline))
            edits.push_back(
                EraseTreePart { plant, DrawTree::Part::OwnOutline, tree->own_outlines[i].id });
    if (!edits.empty())
        return edits;
    if (!tree->trunk.tips.empty() && runs_over(stroke, drawing.trunk))
        edits.push_back(EraseTreePart { plant, DrawTree::Part::Trunk });
    else if (!tree->outline.tips.empty() && runs_over(stroke, drawing.outline[0]))
        edits.push_back(EraseTreePart { plant, DrawTree::Part::Outline });
    if (edits.empty())
        return fail(Fault::User,
                    "the eraser touched nothing of the tree: move it over a line of its drawing");
    return edits;
}

} // namespace

constexpr tools::ToolKind EraseOutlineTool::kKind {
    .word = "erase_outline",
    .label = "Erase",
    .title = "Erase lines of the tree's drawing",
    .done = "The line is erased",
    .help
    = "takes away what was drawn of a tree where the stroke runs over it on paper: the split or "
      "join of bumps, else a branch "
      "on a branch, else a branch, else a branch's own outline, else its trunk or the outline of "
      "its crown",
    .group = "Sketch",
    .method = "From an outline",
    .surface = tools::Surface::Paper,
    .ink = { tools::InkStyle::Look::Eraser, 2 * EraseOutlineTool::kRadius_mm },
    .options = tools::options_type<EraseOutlineTool>(),
    .edits_for = erase,
    .other_end = { &EraseOutlineTool::kKind },
};

} // namespace tractus::silhouette
