#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <vector>

namespace tractus::methods {

// Edits that must follow a step because plants depend on what it changed.
struct Following {
    std::vector<scene::Edit> edits {};
    bool has_leaves = false; // True if some of the edits change leaves.
};

// Finds the edits that must follow a step, in this order: trees whose style is "nearest" take the
// new nearest style (engine/methods/silhouettes/nearest_style.h), and plants with leaves from a
// changed leaf drawing get the new leaves (dependent_leaf_edits() in all_leaves.h).
Following dependent_edits(scene::Scene const& scene, std::vector<scene::Edit> const& step);

} // namespace tractus::methods
