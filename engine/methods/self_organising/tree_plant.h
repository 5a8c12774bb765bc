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
    // One for each axis: the same for the same axis of the same tree in other years.
    AxisKeys keys {};
    std::vector<std::uint32_t> tree_nodes {}; // The tree's node at each of the plant's nodes.
};

// A grown tree as a plant, in millimetres from its base: wood, and leaves on the shoots of the last
// Habit::leaf_years, and on all twigs where a brush has led it. The plant passes check_plant(); it
// has no axes where the tree has no internodes. `seed` decides how leaves differ.
TreePlant plant_of(GrowingTree const& tree, Habit const& habit, std::uint64_t seed);

} // namespace tractus::self_organising
