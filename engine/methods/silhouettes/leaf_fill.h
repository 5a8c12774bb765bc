#pragma once

#include "engine/methods/silhouettes/surface_fit.h"
#include "engine/methods/silhouettes/tree.h"

#include <vector>

namespace tractus::silhouette {

// Limits on where fill_with_leaves() puts leaves.
struct LeafFillLimits {
    // For each axis of the plant: true if its leaves may stick out of the outline, because the
    // axis, or one that bears it, was drawn.
    std::vector<bool> may_stick_out {};
    SurfaceFit const* surface = nullptr; // The drawn crown surface; null: not drawn.
};

// Number of twigs to which a tree may be filled, as a multiple of those that it had before.
constexpr double kMostAdded = 6;

// Makes the leaves of a tree fill its outline (Tree::outline_mm) as seen from the drawing plane
// (TreeOptions::leaves_reach_outline). Twigs whose leaves stick out are shortened or, where that
// is not enough, removed. Then gaps farther from all branches than a twig is long get a branch
// that ends in them, and twigs are added where pixels of the outline are uncovered, until 95 % of
// them are covered or the tree has kMostAdded times as many twigs as before. Twigs must be as
// SprayMaker makes them, and radii must still be unset. Deterministic in the options' seed.
void fill_with_leaves(Tree& tree, TreeOptions const& options, LeafFillLimits const& limits);

} // namespace tractus::silhouette
