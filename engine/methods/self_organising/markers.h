#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// What the buds of a tree perceive around them, one for each bud.
struct Perceived {
    std::vector<double> quality; // Q: 0 where a bud has nothing to grow for.
    std::vector<Vec3> direction; // V: unit vector to grow along; zero where there is none.
};

// Markers of free space. Takes away those nearer than the occupancy radius to a bud, and gives each
// of the others to the nearest bud that perceives it; at equal distances the earlier bud has it. A
// bud with a marker has quality 1, and its direction is the mean of those to its markers (Runions
// et al. 2007). The order of the markers matters only to the last digits of the directions.
Perceived compete_for_space(std::vector<Vec3>& markers, GrowingTree const& tree,
                            std::vector<Bud> const& buds, Laws const& laws);

} // namespace tractus::self_organising
