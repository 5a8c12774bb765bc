#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/growth_noise.h"

#include <vector>

namespace tractus::variation {

// How much the plants of a collection are individuals beside their growth, as plants of one bed
// are. All 0: not at all.
struct Individuality {
    // Share of the lateral branches that a plant lacks, and of those that it has twice, 0 to 0.5: a
    // branch that is lost goes with all that it bears, and one that is added is like a sibling, up
    // to two segments away from it and turned about what bears both.
    double branches = 0;
    double size = 0; // Plants are up to this share larger or smaller, evenly; 0 to 0.5.
    double turn = 0; // Plants are turned by up to this share of a full turn, evenly; 0 to 1.

    bool operator==(Individuality const&) const = default;
};

// Per axis of `plant`: it, or what it bears, is on one of these paths. Such axes are never lost.
std::vector<bool> axes_below_paths(Plant const& plant,
                                   std::vector<std::vector<SegmentId>> const& paths);

// The plant of `key` as an individual. `grown` has the base plant's topology, so that a plant loses
// the same branches at any age; `kept` is per axis: those that stay. What stands on the ground
// stays as well.
Plant individual(Plant const& grown, PlantKey const& key, Individuality const& how,
                 std::vector<bool> const& kept);

// The same without branches that come or go: only turned and larger or smaller.
Plant sized_and_turned(Plant const& grown, PlantKey const& key, Individuality const& how);

} // namespace tractus::variation
