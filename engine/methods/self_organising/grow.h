#pragma once

#include "engine/base/result.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::self_organising {

// Counts of one growth step.
struct StepCount {
    std::size_t buds = 0;    // Number of living buds before the step.
    std::size_t lit = 0;     // Number of buds that received light or space in this step.
    std::size_t grown = 0;   // Number of internodes that grew in this step.
    std::size_t nodes = 0;   // Number of nodes after the step.
    std::size_t markers = 0; // Number of markers left after the step.

    bool operator==(StepCount const&) const = default;
};

// A ball within which buds may grow; buds outside the ball wait.
struct Region {
    Vec3 centre = Vec3::Zero();
    double radius = 0;
};

// The environment of a growing tree.
struct Surroundings {
    std::vector<Vec3> markers {}; // Markers of free space; growth removes used-up markers.
    // Points that cast shade in addition to the tree's own buds; for Laws::Environment::Light.
    std::span<Vec3 const> shading {};
    std::uint64_t seed = 1; // Seed of all random variation.
    // The region in which buds compete for markers; no value: buds compete everywhere. Ignored for
    // Laws::Environment::Light.
    std::optional<Region> region {};
};

// Grows a tree by one step: buds compete, vigour is distributed, shoots grow and starved branches
// are shed. The laws must have passed check_laws(). Fails with a user error for a tree of more than
// Laws::most_nodes nodes or one that spreads over too many cells, and then leaves the tree
// unchanged. The result is bit-identical on any number of threads.
Result<StepCount> grow_step(GrowingTree& tree, Surroundings& surroundings, Laws const& laws);

} // namespace tractus::self_organising
