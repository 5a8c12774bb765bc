#pragma once

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <string>
#include <vector>

namespace tractus::leaf {

// A leaf as a botanist would draw it, flat: its stalk's end at (0, 0), its tip at (0, 1). It has
// formulas of its own and shares nothing with what reads drawings.
struct BotanicalLeaf {
    struct Vein {
        int parent = -1;      // Main vein that bears it; -1: the midrib.
        double at = 0;        // Share of the parent's length.
        double angle_deg = 0; // At its begin, from the parent's direction; positive to the right.
        std::vector<Vec2> line {}; // From its begin to the margin.
    };
    std::vector<Vec2> right {}; // Halves of the margin from base to tip.
    std::vector<Vec2> left {};
    double stalk = 0.2;
    std::vector<Vein> mains {}; // Beside the midrib; angles from the leaf's axis.
    std::vector<Vein> sides {};

    // The margin, closed, counter-clockwise from the base.
    std::vector<Vec2> margin() const;
};

// Beech, birch, ivy, lime, magnolia, maple, oak, willow.
std::vector<std::string> botanical_species();

// One leaf of a species: no two are alike.
BotanicalLeaf botanical_leaf(std::string const& species, Random& random);

} // namespace tractus::leaf
