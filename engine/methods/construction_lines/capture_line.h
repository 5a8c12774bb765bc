#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::lines {

// A pen's stroke as a line of a sketch: points at equal distances of about half a millimetre, the
// hand's tremor taken out by three rounds of reverse subdivision, whose points control a quadratic
// B-spline (Anastacio, Prusinkiewicz, Sousa 2008, section 3). Its polyline is the line: it hardly
// depends on how often the pen's place was taken. `tips` are at least two distinct points. Both
// ends stay. Lines that do not come from a pen need no smoothing.
std::vector<Vec3> capture_line(std::span<Vec3 const> tips);

} // namespace tractus::lines
