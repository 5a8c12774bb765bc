#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/growth_noise.h"

#include <vector>

namespace tractus::variation {

// Individual differences between the plants of a collection in addition to growth, as between
// plants of one bed. All 0: none.
struct Individuality {
    // Share of the lateral branches that are missing, and of those that are duplicated, 0 to 0.5. A
    // branch is removed with all its descendants; a duplicate is placed up to two segments away and
    // rotated about the parent axis.
    double branches = 0;
    double size = 0; // Maximum relative change in size, uniformly distributed; 0 to 0.5.
    // Maximum rotation about the vertical as a share of a full turn, uniformly distributed; 0 to 1.
    double turn = 0;

    bool operator==(Individuality const&) const = default;
};

// By axis of `plant`: true if the axis or one of its descendants is on one of the paths. Such axes
// are never removed.
std::vector<bool> axes_below_paths(Plant const& plant,
                                   std::vector<std::vector<SegmentId>> const& paths);

// Applies the individuality of `key` to a grown plant. `grown` must have the topology of the base
// plant, so that a plant lacks the same branches at any age. `kept`: by axis, true if it must not
// be removed. Axes on the ground are never removed.
Plant individual(Plant const& grown, PlantKey const& key, Individuality const& how,
                 std::vector<bool> const& kept);

// Like individual(), but only rotated and scaled, with all branches.
Plant sized_and_turned(Plant const& grown, PlantKey const& key, Individuality const& how);

} // namespace tractus::variation
