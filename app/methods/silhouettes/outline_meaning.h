#pragma once

#include "app/methods/silhouettes/outline_tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"

#include <optional>

namespace tractus::silhouette {

// The active tree. Fails with a user error if the active plant was not drawn by its outline.
Result<OutlinedTree const*> active_tree(scene::Scene const& scene);

// Interprets a stroke of the tool, finished or not. Over a picture, a touch selects the outline of
// the crown under it (touched_crown.h). A closed stroke is an outline, of the crown or of the
// branch around which it lies (own_outline.h). Any other stroke is the trunk, or a branch of the
// trunk or of the branch on which it begins (own_branch.h).
Result<DrawTree> drawn_tree(OutlineTool const& tool, Stroke const& stroke,
                            scene::Scene const& scene);

// Interprets an open stroke of the leaf option: it declares a part of the crown to be a leaf, or
// revokes that. On a bump in which a branch ends (bump_leaf.h), the part is that branch's part of
// the crown; elsewhere, the smallest outline of the active tree around the stroke's midpoint. No
// value if the stroke is closed and thus an outline. Fails with a user error if the stroke lies
// outside all outlines.
Result<std::optional<scene::Edit>> declared_leaf(OutlineTool const& tool, Stroke const& stroke,
                                                 scene::Scene const& scene);

// The styles that a stroke of the tool copies between branches of the active tree (copied_by() in
// chosen_style.h). Fails with a user error if there is no such tree, and like copied_by().
Result<ChooseStyles> copied_styles(Stroke const& stroke, scene::Scene const& scene);

// The tree after the edit, with all its lines.
Result<OutlinedTree> tree_with(DrawTree const& edit, scene::Scene const& scene);

} // namespace tractus::silhouette
