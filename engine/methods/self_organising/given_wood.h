#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <span>

namespace tractus::self_organising {

// Wood that was drawn or measured, from which a tree grows on.
struct GivenWood {
    Plant const& plant;      // Its axes count. Must outlive the struct, as must the keys.
    AxisKeys const& keys {}; // One for each axis or none: names that the axes keep.
    double internode_mm = 0; // Longer segments are divided; 0: the habit's internode.
    enum class Buds {
        Young, // Only where wood is so young that the habit's lateral buds still live.
        All,   // On all wood: it has been woken.
    } buds
        = Buds::Young;
    // Keeps the plant's radii as the least that the wood has; else the pipe model alone says them.
    bool keeps_width = true;
};

// The wood as a tree that can grow: a node at the end of each segment or of its parts, the terminal
// bud of each axis, and lateral buds as the habit has them. Its age in years follows from how many
// internodes are above each node. What stands on the ground away from the plant's origin is a stem
// of its own (is_stem_of_its_own()). `seed`: of how buds stray. The habit has passed check_habit().
GrowingTree tree_of_wood(GivenWood const& wood, Habit const& habit, std::uint64_t seed);

// Moves a tree's nodes to where those of its plant have been bent to; buds turn with the wood that
// bears them, and the bend is set. `nodes_mm`: of `plant`, as plant_of() made it from this tree.
void bend_tree(GrowingTree& tree, TreePlant const& plant, std::span<Vec3 const> nodes_mm,
               Habit const& habit);

} // namespace tractus::self_organising
