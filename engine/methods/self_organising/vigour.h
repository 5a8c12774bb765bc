#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <vector>

namespace tractus::self_organising {

// How what the buds receive is shared out (extended Borchert-Honda model).
struct Shares {
    std::vector<double> vigour;   // Of each bud.
    std::vector<double> received; // Of each node: the sum over the buds at and above it.
};

// Sums the buds' quality from the tips down; the base has vigour alpha * sum, and at each node the
// axis's continuation gets lambda * Q_main / (lambda * Q_main + (1 - lambda) * Q_laterals) of it,
// the laterals the rest by what each received. `buds` as living_buds() has them.
Shares share_vigour(GrowingTree const& tree, std::vector<Bud> const& buds,
                    std::vector<double> const& quality, Laws const& laws);

} // namespace tractus::self_organising
