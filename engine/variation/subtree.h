#pragma once

#include "engine/plant/plant.h"

#include <vector>

namespace tractus::variation {

// Segments of one axis, from one on to its tip.
struct AxisRest {
    AxisId axis = 0;
    SegmentId first = 0;
};

// `segment`, the rest of its axis, and every axis that these bear, down to the leaf branches; in
// the plant's order.
std::vector<AxisRest> subtree_of(Plant const& plant, SegmentId segment);

} // namespace tractus::variation
