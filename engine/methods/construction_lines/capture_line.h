#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::lines {

// Converts a pen's stroke to a line of a sketch. The stroke is resampled at about half a
// millimetre; three rounds of reverse subdivision remove tremor and give the control points of a
// quadratic B-spline (Anastacio, Prusinkiewicz, Sousa 2008, section 3). The result is that spline
// as a polyline, which hardly depends on the sampling rate of the pen. `tips`: at least two
// distinct points. Both ends are kept. Lines that do not come from a pen need no smoothing.
std::vector<Vec3> capture_line(std::span<Vec3 const> tips);

} // namespace tractus::lines
