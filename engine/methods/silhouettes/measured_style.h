#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/plant/plant.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tractus::silhouette {

// Branching statistics of a plant's axes of one order.
struct MeasuredLevel {
    std::size_t parents = 0; // Number of axes with children.
    std::size_t children = 0;
    BranchStyle style {};
    Pattern pattern = Pattern::Even;
    double node_size = 1; // Mean number of children at one node.
    // Mean divergence angle between consecutive children or nodes, 0 to 180 degrees, and its
    // concentration: 0 for arbitrary angles, 1 if all are equal.
    double divergence_deg = 0;
    double divergence_sureness = 0;
    double mean_angle_deg = 0; // Mean branching angle over all children.
    // Mean child length as a share of the parent's length, in the lower, middle and upper third of
    // the branched part; 0 where there are none.
    std::array<double, 3> lengths {};
};

// The branching style of a plant made by any method.
struct MeasuredStyle {
    // One entry per level: the trunk's branches, then their branches; 1 to 3 entries.
    std::vector<MeasuredLevel> levels;
    int orders = 0;             // Number of branching orders, including twigs that are axes.
    double leaves_per_twig = 0; // Mean number of leaves per twig; 0 if the plant has no leaves.
    double leaf_width = 0;      // Width of a leaf, as a share of its length.
    // True if the plant's twigs are organs (leaf_spray.h) rather than axes.
    bool has_sprays = false;
};

// Measures a plant. A child that goes straight on from its parent's tip is the parent's
// continuation and is not counted. Fails with a user error for a plant without branches.
// Deterministic.
Result<MeasuredStyle> measure_style(Plant const& plant);

// The form of a tree with this style. If the plant's twigs are axes, its last level becomes the
// form's twigs.
TreeForm form_of(MeasuredStyle const& style);

} // namespace tractus::silhouette
