#pragma once

#include "engine/base/random.h"
#include "engine/methods/self_organising/grow.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// Laws of growth and markers that are chosen at random from a seed.
struct RandomCase {
    Laws laws {};
    std::vector<Vec3> markers {};
};

inline RandomCase random_case(std::uint64_t seed, Laws::Environment environment)
{
    Random random({ .seed = seed });
    RandomCase made;
    auto& laws = made.laws;
    laws.environment = environment;
    laws.perception_radius = environment == Laws::Environment::Space ? random.uniform(3, 6) : 3;
    laws.perception_angle_deg = random.uniform(60, 140);
    laws.occupancy_radius = random.uniform(1, 2.5);
    laws.apical_control = random.uniform(0.4, 0.6);
    laws.vigour = random.uniform(1.4, 2.4);
    laws.divergence_deg = random.uniform(80, 180);
    laws.branching_angle_deg = random.uniform(20, 80);
    laws.laterals_at_node = 1 + static_cast<int>(random.uniform(0, 3));
    laws.pipe_exponent = random.uniform(1.8, 3);
    // Each bud of a node casts shade, so the total is divided among the laterals.
    laws.shade = random.uniform(0.04, 0.1) / laws.laterals_at_node;
    laws.shed_below = environment == Laws::Environment::Light ? random.uniform(0, 0.3) : 0;
    for (int i = 0; i < 800; ++i)
        made.markers.emplace_back(random.uniform(-8, 8), random.uniform(-8, 8),
                                  random.uniform(0, 14));
    return made;
}

} // namespace tractus::self_organising
