#pragma once

#include "engine/plant/plant.h"

#include <vector>

namespace tractus {

// A branch as a person sees it: from where it leaves its bearer to its tip. Where an axis ends and
// others continue from its end (sympodial growth), the limb goes on into the thickest of them.
struct Limb {
    std::vector<SegmentId> path; // Each segment stands on the one before. Never empty.
    std::uint32_t order = 0;     // 0 for a trunk, 1 for limbs on it, …
    double length_mm = 0;
};

// All limbs in the order in which a person would draw them: the trunks first, then the limbs of the
// first order, then the second, …; within an order the longest first, and of equals the one that
// stands lower in the plant's arrays. Every segment is in exactly one limb.
std::vector<Limb> limbs(Plant const& plant);

} // namespace tractus
