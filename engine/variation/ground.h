#pragma once

#include "engine/plant/plant.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::variation {

// The ground is the plane z = 0 of the plant's frame.

// A tip lower than this counts as below the ground: rounding and the thickness of what lies on it
// do not.
constexpr double kUnderground_mm = 1;

// The segments of `plant` whose tip is below the ground, though it is not in `base`, which has the
// same topology: not those of roots. In the plant's order.
std::vector<SegmentId> segments_underground(Plant const& plant, Plant const& base);

// "12 of 632 segments are below the ground"; empty where none is.
std::string describe_underground(std::size_t count, Plant const& plant);

// Bends a grown plant along the ground: a segment whose tip would be below it keeps its length and
// heading, and rises just so far that its underside lies on the ground. Segments after it keep
// their own directions, and what it bears turns with it. Axes that go below the ground in `base`,
// as roots do, and what these bear are left as they are. `base` has the same topology.
void bend_along_ground(Plant& plant, Plant const& base);

} // namespace tractus::variation
