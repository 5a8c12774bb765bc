#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::lines {

// A line as a hand draws it ends in hooks where the pen comes down and is lifted, and trembles at 8
// to 12 Hz, which on the sheet is a wave as long as the pen goes meanwhile. Points below are (u, v,
// depth) in millimetres, no two neighbours at one place of the sheet; hooks and tremor are looked
// for on the sheet.

// Whether the points lie as close together as those of a pen's stroke. What a program or a person
// has written as a few corners is exact, and neither trimmed nor smoothed.
bool is_drawn_by_hand(std::span<Vec3 const> points);

// The line without the hooks at its ends: what lies at most 4.5 mm (a fifth of a short line) before
// an end and leaves the course that the line has there. The course comes from a quarter of the
// line's length, 3 to 20 mm.
std::vector<Vec3> trim_hooks(std::span<Vec3 const> points);

// The direction in which a line leaves its first point, from a share of its length that no hook and
// no tremor turns; a unit vector on the sheet.
Vec2 start_direction(std::span<Vec3 const> points);

// The line without the tremor of the hand that drew it: a smoothing spline whose cut-off is set by
// the wavelength and the amplitude that are measured in this line, so that the tremor which is left
// turns the line by less than a degree. A line without tremor stays as it is. Corners of 45 degrees
// and more stay sharp: the line is smoothed from one to the next. Points are half a millimetre
// apart.
std::vector<Vec3> remove_tremor(std::span<Vec3 const> points);

// trim_hooks() and remove_tremor(), for lines that are drawn by hand; others as they are.
std::vector<Vec3> clean_hand_line(std::span<Vec3 const> points);

} // namespace tractus::lines
