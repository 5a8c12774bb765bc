#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

struct TreePlant {
    Plant plant {};
    // Key of each axis; an axis has the same key in every year of the tree.
    AxisKeys keys {};
    // For each node of the plant, the index of the node at the same place in the GrowingTree.
    std::vector<std::uint32_t> tree_nodes {};
};

// Converts a grown tree to a plant, in millimetres from its base, with wood and leaves. Leaves are
// on shoots of the last Habit::leaf_years years and, in a brushed tree, on all twigs. The plant
// passes check_plant(); it has no axes if the tree has no internodes. `seed` drives the variation
// of the leaves.
TreePlant plant_of(GrowingTree const& tree, Habit const& habit, std::uint64_t seed);

// Factor on the width of a trunk's wood at a node: the trunk is wider near the ground, and the
// extra width falls by a factor of e for each trunk width of height. 1 for all other axes.
// `height_mm` is the node's height above the base.
double flare_at(Habit const& habit, NodeLinks const& node, double height_mm,
                double base_diameter_mm);

} // namespace tractus::self_organising
