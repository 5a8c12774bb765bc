#pragma once

#include "app/methods/silhouettes/outline_tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/scene.h"

#include <optional>

namespace tractus::silhouette {

// The tree that takes what is drawn. Fails, as the user's fault, where the plant that does is none
// that was drawn by its outline.
Result<OutlinedTree const*> active_tree(scene::Scene const& scene);

// What a stroke with the tool means: the tips drawn so far, in a document as it is built. Over a
// picture a touch means the outline of the crown that it lies in (touched_crown.h). One that
// comes back to its beginning is an outline, of the crown or of the branch that it lies around
// (own_outline.h), any other a trunk or a branch, of the trunk or of the branch that it begins on
// (own_branch.h).
Result<DrawTree> drawn_tree(OutlineTool const& tool, Stroke const& stroke,
                            scene::Scene const& scene);

// What a stroke with the tool does to a leaf where it does not come back. On a bump in which a
// branch ends (bump_leaf.h) it declares that branch's part of the crown a leaf, and elsewhere the
// smallest outline of the active tree around the stroke's middle; or takes such a leaf back. No
// value: the stroke is an outline. Fails, as the user's fault, where it lies in no outline.
Result<std::optional<scene::Edit>> declared_leaf(OutlineTool const& tool, Stroke const& stroke,
                                                 scene::Scene const& scene);

// The styles that a stroke with the tool carries, in the active tree (carried_by(),
// chosen_style.h). Fails, as the user's fault, where there is no such tree, and like that.
Result<ChooseStyles> carried_styles(Stroke const& stroke, scene::Scene const& scene);

// The tree that the edit would make, with all its lines.
Result<OutlinedTree> tree_with(DrawTree const& edit, scene::Scene const& scene);

} // namespace tractus::silhouette
