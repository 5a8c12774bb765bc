#pragma once

#include "engine/plant/organ_shape.h"

#include <cstddef>
#include <cstdint>

namespace tractus {

// Shape and number of the leaves or needles of a twig.
struct SprayForm {
    int per_spray = 24;   // Number of leaves per twig, 1 to 500.
    double length = 0.3;  // Length of a leaf, as a share of the twig's length.
    double width = 0.4;   // Width of a leaf, as a share of its length.
    double lean_deg = 55; // Angle between leaf and twig.
    // Share of the twig's length, from its base, that has no leaves.
    double first_share = 0.12;
};

constexpr double kSprayLength_mm = 100; // Length of a spray at scale 1.

// A twig's leaves along +y as one organ, so that a tree of a million leaves needs only one organ
// per twig. Each leaf is a lozenge of two triangles; the phyllotaxis is spiral. `variant` selects
// the random stream that makes sprays differ.
OrganShape leaf_spray(SprayForm const& form, MaterialId material, std::uint32_t variant);

// The twig without its leaves.
OrganShape spray_twig(MaterialId material);

} // namespace tractus
