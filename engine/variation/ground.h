#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::variation {

// The ground is the plane z = 0 of the plant's frame.

// A tip deeper than this counts as below the ground. Smaller depths are due to rounding or to the
// thickness of axes that lie on the ground.
constexpr double kUnderground_mm = 1;

// Returns the segments whose tip is below the ground in `plant` but not in `base`, in ascending
// order. So the segments of roots are not included. `base` must have the same topology as `plant`.
std::vector<SegmentId> segments_underground(Plant const& plant, Plant const& base);

// Returns a message such as "12 of 632 segments are below the ground"; an empty string if `count`
// is 0.
std::string describe_underground(std::size_t count, Plant const& plant);

// Bends a grown plant along the ground. A segment whose tip would be below the ground keeps its
// length and heading, and is raised until its underside is on the ground. Later segments of the
// axis keep their directions, and laterals rotate with their parent. Axes that are partly below the
// ground in `base`, such as roots, are not bent, nor are their descendants. `base` must have the
// same topology as `plant`.
void bend_along_ground(Plant& plant, Plant const& base);

} // namespace tractus::variation
