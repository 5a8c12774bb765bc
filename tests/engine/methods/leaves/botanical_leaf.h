#pragma once

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <string>
#include <vector>

namespace tractus::leaf {

// A flat leaf as a botanist would draw it, with the end of its petiole at (0, 0) and its tip at (0,
// 1). Its formulas share nothing with the code that reads drawings.
struct BotanicalLeaf {
    struct Vein {
        int parent = -1; // Index of the main vein that bears it; -1 for the midrib.
        double at = 0;   // Position as a share of the parent's length.
        // Angle at its beginning to the parent's direction; positive to the right.
        double angle_deg = 0;
        std::vector<Vec2> line {}; // Points from its beginning to the margin.
    };
    std::vector<Vec2> right {}; // The halves of the margin, from base to tip.
    std::vector<Vec2> left {};
    double stalk = 0.2;
    // Main veins other than the midrib; angles are from the leaf's axis.
    std::vector<Vein> mains {};
    std::vector<Vein> sides {};

    // Returns the closed margin, counterclockwise from the base.
    std::vector<Vec2> margin() const;
};

// Returns the names: beech, birch, ivy, lime, magnolia, maple, oak, willow.
std::vector<std::string> botanical_species();

// Returns a random leaf of a species.
BotanicalLeaf botanical_leaf(std::string const& species, Random& random);

} // namespace tractus::leaf
