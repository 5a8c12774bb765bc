#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/habit.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <span>

namespace tractus::self_organising {

// Existing wood, drawn or measured, from which a tree continues to grow.
struct GivenWood {
    // Only the plant's axes are used. The plant and the keys must outlive this struct.
    Plant const& plant;
    // Keys from which the axes get their names: one for each axis, or none at all.
    AxisKeys const& keys {};
    // Internode length in mm: longer segments are divided into equal parts of nearly this length.
    // 0: the habit's internode length.
    double internode_mm = 0;
    enum class Buds {
        Young, // Lateral buds only on wood younger than a bud's life (Habit::bud_life).
        All,   // Lateral buds on wood of any age, as if dormant buds had been woken.
    } buds
        = Buds::Young;
    // True: branches are at least as thick as in the given plant. False: the pipe model alone gives
    // their width.
    bool keeps_width = true;
};

// Converts wood into a tree that can grow. Each segment, or each part of a divided one, ends in a
// node; each axis gets a terminal bud, and nodes get lateral buds according to the habit. A node's
// age in years follows from the length of the longest path above it. The axis that begins at the
// plant's origin becomes the trunk; any other axis without a parent becomes an additional stem.
// `seed` drives the random variation of the buds. The habit must have passed check_habit().
GrowingTree tree_from_wood(GivenWood const& wood, Habit const& habit, std::uint64_t seed);

// Moves a tree's nodes to the positions to which its plant was bent. Buds turn with the wood that
// bears them, and the bent shape becomes the rest shape. `nodes_mm` are positions of the nodes of
// `plant`, which plant_of() made from this tree.
void bend_tree(GrowingTree& tree, TreePlant const& plant, std::span<Vec3 const> nodes_mm,
               Habit const& habit);

} // namespace tractus::self_organising
