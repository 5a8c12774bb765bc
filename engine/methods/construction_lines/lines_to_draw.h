#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <vector>

namespace tractus::lines {

// Lines that a sketch lacks, where they might be drawn, millimetres on its sheet, each of at least
// two points. The plant has what they show where something counts in their place: the other
// boundary, mirrored; the only inclination line, for all of the stem; organs that stand at 45
// degrees. Without any boundary they are a proposal: a bow on each side. Inclination lines are
// asked for when there is a boundary that they could reach. Empty where nothing is missing, and for
// a sketch that cannot be measured, or whose boundaries are in space.
std::vector<std::vector<Vec2>> lines_to_draw(LineSketch const& sketch);

} // namespace tractus::lines
