#pragma once

#include "engine/plant/plant.h"

#include <string>

namespace tractus::lsystem {

// Writes a plant as a model in cpfg's language that draws it: arrays with its segments, and two
// rules. A plant that was measured or imported can then be shaped, varied and saved like one from
// an L-system. The derivation length is the number of segments on the longest path from the ground
// to a tip. Axes, segments and radii are numbered differently from the plant's; positions are
// rounded to the language's 32-bit numbers. Organs, polygons and contours are omitted. Turtle units
// are assumed to be 10 mm, the default of TurtleOptions. The plant must not have more than
// kMaxRuledSegments segments.
std::string rules_of_plant(Plant const& plant);

// Maximum number of segments for rules_of_plant(): the maximum size of an array in cpfg's language.
constexpr std::size_t kMaxRuledSegments = 1'000'000;

} // namespace tractus::lsystem
