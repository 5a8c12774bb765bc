#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <vector>

namespace tractus::methods {

// The edits that must be made after a step, because some plants depend on what the step changed.
struct Following {
    std::vector<scene::Edit> edits {};
    bool has_leaves = false; // True if any of these edits changes leaves.
};

// Finds the edits that must be made after a step. First, trees with the style "nearest" take the
// style that is now nearest (engine/methods/silhouettes/nearest_style.h). Then plants whose leaves
// come from a changed leaf drawing get the new leaves (dependent_leaf_edits() in all_leaves.h).
Following dependent_edits(scene::Scene const& scene, std::vector<scene::Edit> const& step);

} // namespace tractus::methods
