#pragma once

#include "app/methods/construction_lines/line_drawing.h"
#include "engine/plant/plant.h"

#include <span>
#include <string>

namespace tractus::lines {

// What a sketch amounts to, as one line of JSON for other programs:
//
//   stem_length  millimetres; all that follows but leaf_tips is in shares of it, and degrees
//   lines        [x, …]: where the inclination lines cross the stem, from below
//   d1, d2       the stem below the lowest line, and above the topmost one
//   node_x       [x, …]
//   functions    {"heading", "depth", "alpha", "beta", "left_size", "right_size"}: each its values
//   at
//                x = 0, 0.05, … 1. Heading is the stem's from up, to the left positive; depth its
//                pitch towards the viewer; alpha and beta are the organs' angles on the left and
//                the right.
//   leaf_tips    [[u, v, w], …]: where the plant that the model gives has its organs' tips,
//                millimetres in the sketch, node after node
//   roles        what strokes were taken for, in their order, if they did not say so: "stem",
//                "left", "right", "inclination", "half inclination", "outline" (both boundaries),
//                "around" or "unsure"; of a stroke that makes a line with an earlier one, as a
//                piece or a correction of it, {"role": "left", "of": 2}, that one's number from 1
//   unplaced     [N, …]: the numbers, from 1, of strokes that are no line of the sketch
//   notes        what had to be guessed
//
// A plant of several stems has the first five members of its first stem, and besides:
//
//   stems        [{…}, …]: for each stem those five; stands_on, the number of the stem that bears
//                it, from 1, or null; stands_at, where on that, a share of its length
//   stroke_stems the number of the stem of each stroke, from 1
std::string print_report(std::span<MeasuredStem const> stems, Plant const& plant,
                         LineDrawing const& drawing);

} // namespace tractus::lines
