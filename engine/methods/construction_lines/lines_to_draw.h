#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <vector>

namespace tractus::lines {

// Suggests lines that a sketch lacks, in millimetres on its sheet, each with at least two points.
// They show the present defaults: the mirror image of the other boundary; a single inclination line
// that applies to the whole stem; organs at 45 degrees. Without any boundary an arc on each side is
// proposed. Inclination lines are suggested once there is a boundary that they could reach. Empty
// if nothing is missing, the sketch cannot be measured, or its boundaries are in space.
std::vector<std::vector<Vec2>> lines_to_draw(LineSketch const& sketch);

} // namespace tractus::lines
