#pragma once

#include "engine/plant/plant.h"

#include <span>
#include <vector>

namespace tractus {

// Returns the plant with its axes joined into branches as people see them. If other axes begin
// where an axis ends (sympodial growth, as in F[+A][-A]), the thickest of them continues it; of
// equally thick ones the straightest, then the first. An axis that starts at a distance from its
// parent's end (a gap) stays separate. Geometry, materials, and the organs on each segment are
// unchanged; orders and the numbers of axes and segments are new.
Plant join_axes(Plant plant);

// Returns the axes in the order in which a person would draw them: trunks first, then by increasing
// order; within an order by decreasing length, and equally long ones by number.
std::vector<AxisId> axes_in_drawing_order(Plant const& plant);

// Returns the axes in drawing order, for callers that already know the arc lengths of the axes.
std::vector<AxisId> axes_in_drawing_order(Plant const& plant,
                                          std::span<double const> axis_length_mm);

// The segments of an axis from base to tip.
std::vector<SegmentId> segments_of(Axis const& axis);

} // namespace tractus
