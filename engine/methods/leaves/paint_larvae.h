#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// Number and appetite of larvae that eat a leaf. Lengths are shares of the picture's side.
struct Larvae {
    int count = 0;
    double min_radius = 0.008; // Minimum radius of a bite; most_radius is the maximum.
    double most_radius = 0.025;
    int min_bites = 15;
    int most_bites = 90;
    int spared_order = 2; // Veins up to this order are not eaten.
};

// Input maps for larvae, `side` by `side` pixels: the coverage of pixels by the leaf, and their
// protection by veins.
struct LarvaGround {
    int side = 0;
    std::span<float const> coverage;
    std::span<float const> protection;
};

// Removes the parts that larvae eat from `alpha`. Each larva moves on bite by bite around the
// spared veins (Peyrat et al. 2008, section 4). `eaten` becomes 1 in holes and fades along their
// rims. Adding a larva does not change the paths of the earlier ones.
void eat(LarvaGround const& ground, Larvae const& larvae, std::uint64_t seed,
         std::span<float> alpha, std::span<float> eaten);

// Paints `count` leaf mines, tunnels of larvae between the upper and lower epidermis that widen
// towards their end. `mined` becomes 1 in them. Mines do not cross spared veins.
void mine(LarvaGround const& ground, int count, std::uint64_t seed, std::span<float> mined);

// Clears the alpha of all parts of the leaf that are not connected to the petiole's end, which is
// at the pixel position `base`.
void keep_connected(LarvaGround const& ground, Vec2 const& base, std::span<float> alpha);

} // namespace tractus::leaf
