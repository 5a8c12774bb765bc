#pragma once

#include "engine/plant/plant.h"

#include <vector>

namespace tractus::variation {

// The segments of one axis from `first` to its tip.
struct AxisRemainder {
    AxisId axis = 0;
    SegmentId first = 0;
};

// Returns the axis of `segment` from that segment to its tip, and all axes that descend from this
// part, in the plant's order.
std::vector<AxisRemainder> subtree_of(Plant const& plant, SegmentId segment);

} // namespace tractus::variation
