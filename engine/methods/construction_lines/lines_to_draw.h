#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <vector>

namespace tractus::lines {

// Suggests lines that a sketch lacks, in millimetres on its sheet, each with at least two points.
// They show what is assumed while these lines are missing: the mirror image of the other boundary;
// a single inclination line that applies to the whole stem; organs at 45 degrees. Without any
// boundary an arc on each side of the stem is suggested. Inclination lines are suggested only once
// there is a boundary. Empty if nothing is missing, the sketch cannot be measured, or its
// boundaries are in space.
std::vector<std::vector<Vec2>> lines_to_draw(LineSketch const& sketch);

} // namespace tractus::lines
