#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// Damage that larvae do to a leaf. Lengths are shares of the picture's side.
struct Larvae {
    int count = 0;
    double least_radius = 0.008; // Radius of a bite,
    double most_radius = 0.025;
    int least_bites = 15;
    int most_bites = 90;
    int spared_order = 2; // Veins up to this order are not eaten.
};

// The pixels that larvae walk over, `side` each way: how much of each the leaf covers, and how far
// a vein protects it.
struct LarvaGround {
    int side = 0;
    std::span<float const> coverage;
    std::span<float const> protection;
};

// Takes from `alpha` what the larvae eat: each goes its way, bite by bite, round the veins that
// are spared (Peyrat et al. 2008, section 4). `eaten` becomes 1 in holes, fading along their rims.
// Another larva more changes nothing in the ways of those before.
void eat(LarvaGround const& ground, Larvae const& larvae, std::uint64_t seed,
         std::span<float> alpha, std::span<float> eaten);

// Ways that larvae have eaten between the leaf's two skins, each wider towards its end: `mined`
// becomes 1 in them. They cross no vein that is spared.
void mine(LarvaGround const& ground, int count, std::uint64_t seed, std::span<float> mined);

// Only what hangs together with the stalk's end keeps its alpha. `base`: that end, in pixels.
void keep_connected(LarvaGround const& ground, Vec2 const& base, std::span<float> alpha);

} // namespace tractus::leaf
