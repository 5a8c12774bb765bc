#pragma once

#include "engine/methods/sketch_lsystem/rule.h"

#include <cstddef>
#include <vector>

namespace tractus::sketch {

// Lengths of a drawn axis's segments, from its base on, in millimetres on the desk.
struct SegmentLengths {
    // Lengths of the first segments: at least one, each above 0.
    std::vector<double> first_mm { 30 };
    double ratio = 1;       // Ratio of each further length to the one before it, above 0.
    double shortest_mm = 0; // The axis ends before the first segment shorter than this.
    int most = 64;          // Maximum number of segments.
};

// The lengths of the drawn axis's segments according to a rule.
SegmentLengths lengths_of(Rule const& rule);

// The length of the segment after segment `number`, which is counted from 0 and is `length_mm`
// long.
double length_after(SegmentLengths const& lengths, std::size_t number, double length_mm);

} // namespace tractus::sketch
