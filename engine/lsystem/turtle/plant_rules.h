#pragma once

#include "engine/plant/plant.h"

#include <string>

namespace tractus::lsystem {

// Writes a plant as a model in cpfg's language that draws it: arrays of its segments and two rules.
// A plant that was measured or imported can then be shaped, varied and saved like one from an
// L-system. The derivation length is the number of segments on the longest path from the ground to
// a tip. The order of axes, segments and radii changes; positions are within the precision of the
// language's 32-bit numbers. Organs, polygons and contours are omitted. Assumes turtle units of 10
// mm, the default of TurtleOptions, and at most kMaxRuledSegments segments.
std::string rules_of_plant(Plant const& plant);

// Maximum number of segments: the maximum size of an array in cpfg's language.
constexpr std::size_t kMaxRuledSegments = 1'000'000;

} // namespace tractus::lsystem
