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

// Trees of which nobody drew more than trunk and crown take the style of the nearest tree that
// somebody refined, or chose a style for (Wither 2009, section 5).

// Whether others may take a tree's style: something was drawn on its branches, styles were carried,
// or somebody has chosen a form or numbers for it.
bool has_own_style(OutlinedTree const& tree);

// Whether a tree takes another one's: it was drawn so, and has none of its own.
bool takes_style(OutlinedTree const& tree);

// The tree with a style of its own whose foot is nearest to a place on the desk, other than
// `except`; of equally near ones that which was drawn first. 0: there is none.
scene::ItemId nearest_with_style(scene::DocumentState const& state, Vec3 const& place_mm,
                                 scene::ItemId except);

// The form with the style measured of a plant (measured_style.h) in place of its own; its seed,
// and how its nodes are kept, stay. Fails like measure_style().
Result<TreeForm> with_style_of(TreeForm form, Plant const& plant);

// The edits that a step brings with it: trees that take a style follow the nearest tree that has
// one, where that has changed or is another one now.
std::vector<scene::Edit> styles_that_follow(scene::Scene const& scene,
                                            std::vector<scene::Edit> const& step);

} // namespace tractus::silhouette
