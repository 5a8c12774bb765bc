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

// What one step did.
struct StepCount {
    std::size_t buds = 0;    // Living buds before it,
    std::size_t lit = 0;     // those of them that received something,
    std::size_t grown = 0;   // internodes that grew,
    std::size_t nodes = 0;   // nodes after it,
    std::size_t markers = 0; // and markers that are left.

    bool operator==(StepCount const&) const = default;
};

// A ball; what is outside waits.
struct Region {
    Vec3 centre = Vec3::Zero();
    double radius = 0;
};

// What a tree grows in.
struct Surroundings {
    std::vector<Vec3> markers {};     // Of free space; those that are used up go.
    std::span<Vec3 const> shading {}; // What shades it besides its own buds, in Light.
    std::uint64_t seed = 1;           // Of what is left to chance.
    // Where buds compete for markers; no value: everywhere. In Light all do.
    std::optional<Region> region {};
};

// One step: buds compete, vigour is shared out, shoots grow, starved branches are shed. The laws
// have passed check_laws(). Fails, as the user's fault, for a tree of more than Laws::most_nodes
// nodes, or one that spreads over too many cells; it is then as before the step. The same bytes on
// any number of threads.
Result<StepCount> grow_step(GrowingTree& tree, Surroundings& surroundings, Laws const& laws);

} // namespace tractus::self_organising
