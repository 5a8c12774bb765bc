#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/methods/silhouettes/tree_form.h"
#include "engine/plant/plant.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <optional>
#include <vector>

namespace tractus::silhouette {

// Trees of which only trunk and crown were drawn take the style of the nearest tree that has a
// style of its own, refined or chosen by hand (Wither 2009, section 5).

// True if other trees may take this tree's style: something was drawn on its branches, styles were
// copied between them, or a form or its numbers were set by hand.
bool has_own_style(OutlinedTree const& tree);

// True if the tree takes another tree's style: this was chosen when it was drawn, and nothing has
// given it a style of its own since.
bool takes_style(OutlinedTree const& tree);

// Id of the tree with its own style whose foot is nearest to a point in the scene, other than
// `except`; the one drawn first if several are equally near. 0 if there is none.
scene::ItemId nearest_with_style(scene::DocumentState const& state, Vec3 const& place_mm,
                                 scene::ItemId except);

// `form` with the style measured on a plant (measured_style.h); its seed, has_whole_nodes and
// plane_branches, leaves_reach_outline and bases_by_angle stay. Fails like measure_style().
Result<TreeForm> with_style_of(TreeForm form, Plant const& plant);

// Additional edits that become necessary with the edits of `step`: a tree that takes the style of
// the nearest tree is updated if that nearest tree changes or a different tree becomes the nearest.
std::vector<scene::Edit> dependent_style_edits(scene::Scene const& scene,
                                               std::vector<scene::Edit> const& step);

} // namespace tractus::silhouette
