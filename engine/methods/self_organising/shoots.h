#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// A bud that grows in this step.
struct Shoot {
    Bud bud {};
    int internodes = 1;
    double length = 1;        // Of each internode.
    Vec3 pull = Vec3::Zero(); // V: the bud's best direction.
};

// How many internodes a bud of that vigour makes, and how long they are. None below 1. `order`: of
// the axis that would grow.
Shoot shoot_of(Bud const& bud, std::size_t order, double vigour, Laws const& laws);

// Gives the lateral positions of a node their buds: around it by the divergence, out by the
// branching angle. `seed` as grow_shoots() has it.
void set_lateral_buds(GrowingTree& tree, std::uint32_t node, Laws const& laws, std::uint64_t seed);

// Adds the shoots' nodes, those of earlier shoots first, each with its lateral buds. Each internode
// turns: d <- unit(d + space_weight * pull + tropism_weight * tropism_direction). The nodes' step
// is tree.step. `seed` decides how lateral buds stray and which terminal buds die: by the names of
// axes alone, so that an axis fares alike in a tree that has grown otherwise elsewhere.
void grow_shoots(GrowingTree& tree, std::vector<Shoot> const& shoots, Laws const& laws,
                 std::uint64_t seed);

} // namespace tractus::self_organising
