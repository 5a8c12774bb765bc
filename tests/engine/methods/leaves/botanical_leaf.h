#pragma once

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <string>
#include <vector>

namespace tractus::leaf {

// A flat leaf as a botanist would draw it. The end of its petiole is at (0, 0), and its tip at (0,
// 1). Its formulas share nothing with the code that reads drawings.
struct BotanicalLeaf {
    struct Vein {
        // Index of the main vein from which this vein branches off; -1: the midrib.
        int parent = -1;
        double at = 0; // Position on the parent vein, as a share of its length.
        // Angle between the beginning of the vein and the parent's direction; positive to the
        // right.
        double angle_deg = 0;
        std::vector<Vec2> line {}; // Points from the beginning of the vein to the margin.
    };
    std::vector<Vec2> right {}; // Right and left half of the margin, from base to tip.
    std::vector<Vec2> left {};
    double stalk = 0.2;
    // Main veins without the midrib. Their angles are measured from the leaf's axis.
    std::vector<Vein> mains {};
    std::vector<Vein> sides {};

    // Returns the closed margin, which runs counterclockwise from the leaf's base.
    std::vector<Vec2> margin() const;
};

// Returns the names of the species: beech, birch, ivy, lime, magnolia, maple, oak, willow.
std::vector<std::string> botanical_species();

// Returns a random leaf of the given species.
BotanicalLeaf botanical_leaf(std::string const& species, Random& random);

} // namespace tractus::leaf
