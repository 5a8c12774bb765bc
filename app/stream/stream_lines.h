#pragma once

#include "app/station/station.h"
#include "app/tools/tool.h"

#include <cstddef>
#include <string>

namespace tractus::stream {

// Lines of `tractus stream` for other programs: one JSON object per line, in ASCII, including the
// line end. app/manual/streaming.md documents them; removals and changes of meaning raise the
// version, additions do not. Lengths are in millimetres of the world frame with three decimals,
// pressures 0 to 1 with four, angles in degrees with two, times in seconds of the log or the
// monotonic clock with nine.

constexpr int kStreamVersion = 1;

// The first line: version, and the corners of the volume that the pen can reach
// (Station::volume_mm()).
std::string stream_line(Bounds const& volume_mm);

// The pen's current position; later height readings may correct its height.
std::string tip_line(station::PenMoment const& moment);

// A finished stroke with settled tips, and its tool. `number` counts strokes; the stroke must have
// tips.
std::string stroke_line(std::size_t number, tools::ToolStroke const& stroke);

// The end of a growth step along an unfinished stroke. `number` counts from 1; `began` is the start
// of the stroke, `time` that of the pen sample that completed the step.
std::string step_line(std::size_t number, Timestamp began, Timestamp time, Vec3 const& end_mm);

// The number of tip lines that were dropped because the reader was too slow.
std::string lost_line(std::size_t tips);

// The last line of a stream.
std::string end_line();

} // namespace tractus::stream
