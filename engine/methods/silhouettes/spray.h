#pragma once

#include "engine/plant/organ_shape.h"

#include <cstddef>
#include <cstdint>

namespace tractus::silhouette {

// The leaves of a twig.
struct LeafForm {
    int per_spray = 24;   // 1 to 500.
    double length = 0.3;  // Shares of the twig's length.
    double width = 0.4;   // Share of the leaf's own length.
    double lean_deg = 55; // From the twig.
};

constexpr double kSprayLength_mm = 100; // Of a spray at scale 1.

// The leaves of a twig along +y as one organ, so that a tree of a million leaves has no more organs
// than twigs. Each leaf is a lozenge of two triangles; they stand in a spiral. `variant` chooses
// the random numbers by which sprays differ.
OrganShape leaf_spray(LeafForm const& form, MaterialId material, std::uint32_t variant);

// The twig itself.
OrganShape spray_twig(MaterialId material);

} // namespace tractus::silhouette
