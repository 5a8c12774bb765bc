#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/stroke_lie.h"

#include <span>
#include <vector>

namespace tractus::lines {

using Polyline = std::vector<Vec3>; // (u, v, depth) in millimetres.

// How well one line goes on where another ends.
struct Junction {
    double quality = 0; // 1: without a gap and a turn; 0: not at all.
    bool at_end_of_first = true;
    bool at_end_of_second = false;
};

// The best junction of two lines' ends, for gaps up to `most_gap_mm`. Lines that run side by side
// do not go on in each other.
Junction junction_of(Polyline const& first, Polyline const& second, double most_gap_mm);

// Both as one line, in the direction of the first.
Polyline joined(Polyline const& first, Polyline const& second, Junction const& at);

// Turned so that it rises along the axis.
Polyline rising(Polyline line, StemAxis const& axis);

// A line with another one over it that rises likewise: a piece that goes on where the line ends or
// begins is added, a part that is drawn again replaces what lies between the places where it leaves
// the line and meets it again, and a line that does neither replaces the whole.
Polyline drawn_over(Polyline const& line, Polyline const& over, StemAxis const& axis);

} // namespace tractus::lines
