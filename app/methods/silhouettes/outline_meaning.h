#pragma once

#include "app/methods/silhouettes/outline_tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::silhouette {

// The active plant as a tree drawn by its outline. Fails with a user error if it was not drawn so.
Result<OutlinedTree const*> active_tree(scene::Scene const& scene);

// Interprets a stroke of the tool, finished or not. If there is a picture behind the drawing, a
// mere touch selects the outline of the crown in the picture (touched_crown.h). A closed stroke is
// the outline of the crown, or of the branch around which it was drawn (own_outline.h). Any other
// stroke is the trunk, or a branch of the trunk or of the branch on which it begins (own_branch.h).
// One that was drawn from its tip to its foot is reversed (Reads::FootFirst).
Result<DrawTree> drawn_tree(OutlineTool const& tool, Stroke const& stroke,
                            scene::Scene const& scene);

// Interprets an open stroke of the tool's leaf option: it declares a part of the crown to be a
// leaf, or revokes that. On a bump in which a branch ends (bump_leaf.h), this is the part of the
// crown that belongs to the branch. Elsewhere, it is the smallest outline of the active tree around
// the stroke's midpoint. Returns no value if the stroke is closed and thus an outline. Fails with a
// user error if the stroke is outside all outlines.
Result<std::optional<scene::Edit>> declared_leaf(OutlineTool const& tool, Stroke const& stroke,
                                                 scene::Scene const& scene);

// The styles that a stroke of the tool copies from one branch of the active tree to others
// (copied_by() in chosen_style.h). Fails with a user error if the active plant was not drawn by its
// outline, or the stroke begins on none of its branches.
Result<ChooseStyles> copied_styles(Stroke const& stroke, scene::Scene const& scene);

// The edits that reverse the trunk or the drawn branch that a stroke of the tool touches: what was
// its tip becomes its foot. Fails with a user error if there is none, or if the reversed line is no
// part of the tree.
Result<std::vector<scene::Edit>> turned_line(OutlineTool const& tool, Stroke const& touch,
                                             scene::Scene const& scene);

// The tree that the edit begins or changes, with all its lines, after the edit.
Result<OutlinedTree> tree_with(DrawTree const& edit, scene::Scene const& scene);

} // namespace tractus::silhouette
