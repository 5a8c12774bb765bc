#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::lines {

// Converts a pen's stroke to a line of a sketch: resampled at about half a millimetre, tremor
// removed by three rounds of reverse subdivision, whose points are the control points of a
// quadratic B-spline (Anastacio, Prusinkiewicz, Sousa 2008, section 3). The result is that spline
// as a polyline; it hardly depends on the sampling rate of the pen. `tips`: at least two distinct
// points. Both ends are kept. For lines that do not come from a pen smoothing is unnecessary.
std::vector<Vec3> capture_line(std::span<Vec3 const> tips);

} // namespace tractus::lines
