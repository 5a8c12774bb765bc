#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::lines {

// Functions that remove artefacts of hand-drawn lines: hooks at the ends, where the pen comes down
// and is lifted, and tremor of 8 to 12 Hz, which appears on the sheet as a wave whose length
// depends on the speed of the pen. Points are (u, v, depth) in millimetres, with no two neighbours
// coinciding on the sheet; hooks and tremor are analysed on the sheet.

// True if the points are as close together as those of a pen's stroke. A line of a few corners,
// entered by a program or a person, is exact: it is neither trimmed nor smoothed.
bool is_drawn_by_hand(std::span<Vec3 const> points);

// Removes the hooks at a line's ends. A hook is an end piece, at most 4.5 mm and at most a fifth of
// the line long, that departs from the line's course. The course near an end is determined from a
// quarter of the line's length, 3 to 20 mm.
std::vector<Vec3> trim_hooks(std::span<Vec3 const> points);

// Returns the direction of a line at its first point, a unit vector on the sheet, measured over a
// part of its length that is insensitive to hooks and tremor.
Vec2 start_direction(std::span<Vec3 const> points);

// Removes hand tremor with a smoothing spline. The spline's cut-off is chosen from the wavelength
// and amplitude of the tremor measured in this line, so that the remaining tremor turns the line by
// less than one degree. A line without tremor is unchanged. Corners of 45 degrees and more stay
// sharp: the line is smoothed between them. The resulting points are half a millimetre apart.
std::vector<Vec3> remove_tremor(std::span<Vec3 const> points);

// Applies trim_hooks() and remove_tremor() to hand-drawn lines; returns others unchanged.
std::vector<Vec3> clean_hand_line(std::span<Vec3 const> points);

} // namespace tractus::lines
