#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/growth_noise.h"

#include <vector>

namespace tractus::variation {

// Individual differences between the plants of a collection, in addition to those of growth. If all
// are 0, the plants differ only by growth.
struct Individuality {
    // Share of the lateral branches that are missing, and equally the share that are duplicated, 0
    // to 0.5. A branch is removed with all its descendants; a duplicate is placed up to two
    // segments away and rotated about the parent axis.
    double branches = 0;
    // Maximum relative change in size, uniformly distributed, for a plant that is as wide as high
    // or wider; 0 to 0.5. For a narrower plant the maximum is larger, by a factor of up to
    // kNarrowSize.
    double size = 0;
    // Maximum rotation about the vertical as a share of a full turn, uniformly distributed; 0 to 1.
    double turn = 0;
    // Maximum share by which a plant is younger than the oldest plant, uniformly distributed; 0 to
    // 0.9.
    double age = 0;
    // Maximum relative change in the size of leaves and other organs, uniformly distributed; 0 to
    // 0.5.
    double organs = 0;
    // Share of the plants whose model runs its stochastic rules with a seed of its own
    // (with_own_seed() in engine/scene/varied_scene.h); 0 to 1.
    double seeds = 0;

    bool operator==(Individuality const&) const = default;
};

// Factor on Individuality::size for a plant without width: turned about the vertical, it would look
// the same. The factor falls linearly to 1 for plants as wide as high.
constexpr double kNarrowSize = 2;
constexpr double kMaxSize = 0.8; // Maximum relative change in size, however narrow the plant.

// Default individuality of a collection: differences like those between plants of one bed.
constexpr Individuality kPlantsOfOneBed {
    .branches = 0.08, .size = 0.4, .turn = 1, .age = 0.25, .organs = 0.15, .seeds = 1
};

// Returns the age of the plant of `key`, if the oldest plant has the age `age`.
double individual_age(PlantKey const& key, Individuality const& how, double age = 1);

// True if the plant of `key` has a seed of its own for its model's stochastic rules.
bool has_own_seed(PlantKey const& key, Individuality const& how);

// Returns, for each axis of `plant`, whether the axis or one of its descendants is on one of the
// paths. The callers of individual() protect these axes from removal.
std::vector<bool> axes_below_paths(Plant const& plant,
                                   std::vector<std::vector<SegmentId>> const& paths);

// Applies the individuality of `key` to a grown plant. `grown` must have the topology of the base
// plant, so that a plant lacks the same branches at any age. `kept`: for each axis, true if it must
// not be removed. Axes on the ground are never removed.
Plant individual(Plant const& grown, PlantKey const& key, Individuality const& how,
                 std::vector<bool> const& kept);

// Like individual(), but with the topology of `grown`, so that plants can be compared node by node.
// A missing branch shrinks to the point where it would begin, and no branch is duplicated.
Plant comparable_individual(Plant const& grown, PlantKey const& key, Individuality const& how,
                            std::vector<bool> const& kept);

} // namespace tractus::variation
