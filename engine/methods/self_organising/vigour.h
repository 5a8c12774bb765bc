#pragma once

#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <vector>

namespace tractus::self_organising {

// Distribution of vigour by the extended Borchert-Honda model.
struct Shares {
    std::vector<double> vigour; // Vigour of each bud.
    // Light or space received at each node: the sum over the buds at the node and above it.
    std::vector<double> received;
};

// Sums the buds' quality from the tips to the base and distributes vigour upwards. The base has
// vigour alpha * sum (alpha: Laws::vigour). At each node the main axis gets the share lambda *
// Q_main / (lambda * Q_main + (1 - lambda) * Q_laterals) of the node's vigour (lambda:
// Laws::apical_control); the laterals divide the rest in proportion to the quality that each
// received. `buds` come from living_buds().
Shares share_vigour(GrowingTree const& tree, std::vector<Bud> const& buds,
                    std::vector<double> const& quality, Laws const& laws);

} // namespace tractus::self_organising
