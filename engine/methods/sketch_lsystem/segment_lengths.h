#pragma once

#include "engine/methods/sketch_lsystem/rule.h"

#include <cstddef>
#include <vector>

namespace tractus::sketch {

// How long the segments of a drawn axis are, from its base on, in millimetres on the desk.
struct SegmentLengths {
    std::vector<double> first_mm { 30 }; // At least one, each above 0.
    double ratio = 1;                    // Each further one by the one before it, above 0.
    double shortest_mm = 0;              // Where one would be shorter, the axis ends.
    int most = 64;                       // Segments.
};

// The lengths that a rule gives.
SegmentLengths lengths_of(Rule const& rule);

// The length of the segment after number `number`, from 0, which is so long.
double length_after(SegmentLengths const& lengths, std::size_t number, double length_mm);

} // namespace tractus::sketch
