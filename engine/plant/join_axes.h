#pragma once

#include "engine/plant/plant.h"

#include <span>
#include <vector>

namespace tractus {

// Returns the plant with axes as a person sees branches: where an axis ends and others continue
// from its end (sympodial growth, as in F[+A][-A]), it goes on into the thickest of them. Of
// equally thick ones the straightest goes on, then the first. An axis that starts elsewhere than
// where its parent ends (a gap) stays apart. Geometry, materials and what rides on each segment
// stay as they are; orders, and the numbers of axes and segments, are new.
Plant join_axes(Plant plant);

// The axes in the order in which a person would draw them: the trunks first, then the first order,
// then the second, …; within an order the longest first, and of equals the one that comes first.
std::vector<AxisId> axes_in_drawing_order(Plant const& plant);

// Serves a caller that knows the axes' lengths along their segments.
std::vector<AxisId> axes_in_drawing_order(Plant const& plant,
                                          std::span<double const> axis_length_mm);

// The segments of an axis from base to tip.
std::vector<SegmentId> segments_of(Axis const& axis);

} // namespace tractus
