#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/stroke_position.h"

#include <span>
#include <vector>

namespace tractus::lines {

using Polyline = std::vector<Vec3>; // Points of a line, (u, v, depth) in millimetres.

// Quality of the continuation of one line by another.
struct Junction {
    double quality = 0; // 1: without gap and turn; 0: the lines do not join.
    bool at_end_of_first = true;
    bool at_end_of_second = false;
};

// Returns the best junction of two lines' ends, for gaps up to `most_gap_mm`. Lines that run side
// by side do not continue each other.
Junction junction_of(Polyline const& first, Polyline const& second, double most_gap_mm);

// Joins two lines into one, in the direction of the first.
Polyline joined(Polyline const& first, Polyline const& second, Junction const& at);

// Reverses a line if necessary, so that it runs upwards along the axis.
Polyline rising(Polyline line, StemAxis const& axis);

// Combines a line with a correction of the same direction: a piece that extends the line is
// appended or prepended, a part that is redrawn replaces the section between the points where it
// leaves and meets the line, and a line that does neither replaces the whole.
Polyline merge_correction(Polyline const& line, Polyline const& over, StemAxis const& axis);

} // namespace tractus::lines
