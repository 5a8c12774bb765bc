#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/self_organising/growing_tree.h"
#include "engine/methods/self_organising/laws.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// The light or space that each bud of a tree perceives.
struct BudPerception {
    // Q of each bud: the light or space that the bud perceives; 0: none.
    std::vector<double> quality;
    // V of each bud: unit vector of the direction in which the bud should grow; zero if the bud
    // perceives nothing.
    std::vector<Vec3> direction;
};

// Lets buds compete for markers of free space. Removes markers within the occupancy radius of any
// bud; each other marker goes to the nearest bud that perceives it, at equal distances to the
// earlier bud. A bud with a marker gets quality 1 and the mean direction to its markers (Runions et
// al. 2007). The order of the markers affects only the last digits of the directions.
BudPerception compete_for_space(std::vector<Vec3>& markers, GrowingTree const& tree,
                                std::vector<Bud> const& buds, Laws const& laws);

} // namespace tractus::self_organising
