#pragma once

#include "app/station/station.h"
#include "app/tools/tool.h"

#include <cstddef>
#include <string>

namespace tractus::stream {

// Lines of `tractus stream` for other programs. Each line is a JSON object in ASCII, including the
// line end. app/manual/streaming.md documents them. If a field is removed or changes its meaning,
// the version is increased; additions do not change the version. Lengths are in millimetres of the
// world frame with three decimals, pressures from 0 to 1 with four, angles in degrees with two, and
// times in seconds of the log or the monotonic clock with nine.

constexpr int kStreamVersion = 1;

// Returns the first line of a stream: the version, and the corners of the volume that the pen can
// reach (Station::volume_mm()).
std::string stream_line(Bounds const& volume_mm);

// Returns a line with the pen's current position. Later height readings may correct the height.
std::string tip_line(station::PenMoment const& moment);

// Returns a line with a finished stroke, whose tips no longer change, and its tool. `number` counts
// the stream's strokes. The stroke must have tips.
std::string stroke_line(std::size_t number, tools::ToolStroke const& stroke);

// Returns a line with the end of a growth step along an unfinished stroke. `number` counts the
// steps from 1; `began` is the time of the stroke's first tip, `time` that of the pen sample that
// completed the step.
std::string step_line(std::size_t number, Timestamp began, Timestamp time, Vec3 const& end_mm);

// Returns a line with the number of tip lines that were dropped because the reader was too slow.
std::string lost_line(std::size_t tips);

// Returns the last line of a stream.
std::string end_line();

} // namespace tractus::stream
