#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::variation {

// The ground is the plane z = 0 of the plant's frame.

// A tip below -kUnderground_mm counts as below the ground; smaller depths are due to rounding or to
// the thickness of axes that lie on the ground.
constexpr double kUnderground_mm = 1;

// Returns the segments, in the order of `plant`, whose tip is below the ground in `plant` but not
// in `base`, a plant of the same topology. So the segments of roots are not included.
std::vector<SegmentId> segments_underground(Plant const& plant, Plant const& base);

// Returns a message such as "12 of 632 segments are below the ground"; an empty string if `count`
// is 0.
std::string describe_underground(std::size_t count, Plant const& plant);

// Bends a grown plant along the ground: a segment whose tip would be below it keeps its length and
// heading and is raised until its underside is on the ground. Later segments of the axis keep their
// directions, and laterals rotate with their parent. Axes that are below the ground in `base`, such
// as roots, and their descendants are not changed. `base` has the same topology.
void bend_along_ground(Plant& plant, Plant const& base);

} // namespace tractus::variation
