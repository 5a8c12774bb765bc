#pragma once

#include "app/methods/construction_lines/line_drawing.h"
#include "engine/plant/plant.h"

#include <span>
#include <string>

namespace tractus::lines {

// Formats the measurements of a sketch as one line of JSON for other programs:
//
//   stem_length  millimetres; lengths below, except leaf_tips, are shares of it; angles in degrees
//   lines        [x, …]: where the inclination lines cross the stem, from the base
//   d1, d2       length of the stem below the lowest line, and above the topmost one
//   node_x       [x, …]: places of the nodes
//   functions    {"heading", "depth", "alpha", "beta", "left_size", "right_size"}: values of each
//                at x = 0, 0.05, … 1. "heading" is the stem's angle from up, positive to the left;
//                "depth" its pitch towards the viewer; "alpha" and "beta" are the angles of the
//                left and right organs
//   leaf_tips    [[u, v, w], …]: organ tips of the plant that the model gives, in millimetres of
//                the sketch, node after node
//   roles        recognised roles of strokes that did not state one, in the strokes' order:
//                "stem", "left", "right", "inclination", "half inclination", "outline" (both
//                boundaries), "around" or "unsure". A stroke that continues or corrects an earlier
//                one is {"role": "left", "of": 2}, where 2 is that one's number, counted from 1
//   unplaced     [N, …]: the numbers, counted from 1, of strokes outside the sketch
//   notes        guesses that had to be made
//
// A plant of several stems has the first five members for its first stem, and also:
//
//   stems        [{…}, …]: those five members for each stem, and stands_on, the number of the
//                stem that bears it, counted from 1, or null; stands_at, the place on that stem as
//                a share of its length
//   stroke_stems the number of each stroke's stem, counted from 1
std::string print_report(std::span<MeasuredStem const> stems, Plant const& plant,
                         LineDrawing const& drawing);

} // namespace tractus::lines
