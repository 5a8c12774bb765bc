#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// A shoot: the internodes that a bud grows in one step.
struct Shoot {
    Bud bud {};
    int internodes = 1;
    double length = 1;        // Length of each internode of the shoot.
    Vec3 pull = Vec3::Zero(); // V: the bud's preferred direction.
};

// The shoot that a bud with this vigour grows; it has no internodes for a vigour below 1. `order`
// is the branching order of the shoot's axis.
Shoot shoot_of(Bud const& bud, std::size_t order, double vigour, Laws const& laws);

// Puts a bud at each lateral position of a node: around the node by the divergence angle and
// outwards by the branching angle. `seed` is the seed given to grow_shoots().
void set_lateral_buds(GrowingTree& tree, std::uint32_t node, Laws const& laws, std::uint64_t seed);

// Adds the nodes of all shoots, in the shoots' order, each node with its lateral buds. Each
// internode changes direction: d <- unit(d + space_weight * pull + tropism_weight *
// tropism_direction). The new nodes get the step tree.step. `seed` decides the variation of lateral
// buds and which terminal buds die. It is combined only with a node's axis name and rank, so an
// axis varies in the same way even if other parts of the tree differ.
void grow_shoots(GrowingTree& tree, std::vector<Shoot> const& shoots, Laws const& laws,
                 std::uint64_t seed);

} // namespace tractus::self_organising
