#pragma once

#include "engine/plant/plant.h"

#include <string>

namespace tractus::lsystem {

// A plant as a model in cpfg's language that draws it: arrays of its segments and two rules. So a
// plant that was measured, or comes from another program, is what an L-system's plant is: it can be
// shaped, varied and kept in a session. Its derivation is as long as its longest way from the
// ground to a tip. Axes, segments and radii come back in another order; places within the precision
// of the language's 32-bit numbers. Organs, polygons and contours stay behind. For turtle units of
// 10 mm, as in TurtleOptions. For at most kMaxRuledSegments.
std::string rules_of_plant(Plant const& plant);

constexpr std::size_t kMaxRuledSegments = 1'000'000; // As many as an array may have elements.

} // namespace tractus::lsystem
