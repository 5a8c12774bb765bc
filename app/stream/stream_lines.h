#pragma once

#include "app/station/station.h"
#include "app/tools/tool.h"

#include <cstddef>
#include <string>

namespace tractus::stream {

// Lines of `tractus stream` for other programs: one JSON object a line, in ASCII, each with its
// line's end. app/manual/streaming.md describes them for whoever reads them; whatever is taken from
// them or changes its meaning raises the version, and what is added does not.
//
// Lengths are millimetres of the world frame with three decimals, pressures 0 to 1 with four,
// angles degrees with two, times seconds of the log or of the monotonic clock with nine.

constexpr int kStreamVersion = 1;

// The first line: what follows, and within which corners the pen can be (Station::volume_mm()).
std::string stream_line(Bounds const& volume_mm);

// Where a pen is now: with a height that later readings may correct.
std::string tip_line(station::PenMoment const& moment);

// A finished stroke, the `number`-th, whose tips are settled, and what it is for. It has tips.
std::string stroke_line(std::size_t number, tools::ToolStroke const& stroke);

// The end of the `number`-th step, from 1 on, by which something grows along the stroke that began
// at `began`, and the time of the pen's sample that made it.
std::string step_line(std::size_t number, Timestamp began, Timestamp time, Vec3 const& end_mm);

// Says how many lines of tips were left out, since the reader was too slow for them.
std::string lost_line(std::size_t tips);

// The last line.
std::string end_line();

} // namespace tractus::stream
