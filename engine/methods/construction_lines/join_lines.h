#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/stroke_position.h"

#include <span>
#include <vector>

namespace tractus::lines {

using Polyline = std::vector<Vec3>; // Points of a line, (u, v, depth) in millimetres.

// The ends at which one line continues another, and how well it does so.
struct Junction {
    double quality = 0; // 1: without gap and turn; 0: the lines do not continue each other.
    bool at_end_of_first = true;
    bool at_end_of_second = false;
};

// Returns the best junction between an end of one line and an end of the other, for gaps up to
// `most_gap_mm`. Lines that run side by side do not continue each other.
Junction junction_of(Polyline const& first, Polyline const& second, double most_gap_mm);

// Joins two lines at this junction into one line, in the direction of the first.
Polyline joined(Polyline const& first, Polyline const& second, Junction const& at);

// Reverses a line if necessary, so that it runs upwards along the axis.
Polyline rising(Polyline line, StemAxis const& axis);

// Combines a line with a correction drawn in the same direction. The correction replaces the part
// of the line between the points nearest to its own ends. Each remaining end of the line is kept if
// the correction meets the line there, if the two lines hardly overlap along the axis and so are
// pieces of one line, or if the end extends beyond the correction by more than a fifth of the stem.
Polyline merge_correction(Polyline const& line, Polyline const& over, StemAxis const& axis);

} // namespace tractus::lines
