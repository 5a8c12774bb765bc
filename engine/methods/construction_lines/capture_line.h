#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::lines {

// Converts a pen's stroke to a line of a sketch. The stroke is resampled at steps of about half a
// millimetre; three rounds of reverse subdivision remove tremor and give the control points of a
// quadratic B-spline (Anastacio, Prusinkiewicz, Sousa 2008, section 3). The result is that spline
// as a polyline, which hardly depends on the pen's sampling rate and keeps the stroke's end points.
// Lines that do not come from a pen need no such smoothing. `tips`: at least two distinct points.
std::vector<Vec3> capture_line(std::span<Vec3 const> tips);

} // namespace tractus::lines
