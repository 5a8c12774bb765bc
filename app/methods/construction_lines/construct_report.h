#pragma once

#include "app/methods/construction_lines/line_drawing.h"
#include "engine/plant/plant.h"

#include <span>
#include <string>

namespace tractus::lines {

// Formats the measurements of a sketch as one line of JSON for other programs:
//
//   stem_length  length of the stem in millimetres; other lengths, except leaf_tips, are shares of
//                it. Angles are in degrees
//   lines        [x, …]: where the inclination lines cross the stem, from the base
//   d1, d2       length of the stem below the lowest line, and above the topmost one
//   node_x       [x, …]: places of the nodes
//   functions    {"heading", "depth", "alpha", "beta", "left_size", "right_size"}: values of each
//                at x = 0, 0.05, … 1. "heading" is the stem's angle from up, positive to the left;
//                "depth" its pitch towards the viewer; "alpha" and "beta" are the angles of the
//                left and right organs
//   boundaries   [{"azimuth", "size": […]}, …]: for each boundary in space, if there are any, its
//                azimuth and the sizes of organs along it at x = 0, 0.05, … 1
//   leaf_tips    [[u, v, w], …]: organ tips of the plant that the model gives, in millimetres of
//                the sketch, node after node
//   roles        recognised roles of strokes that did not state one, in the strokes' order:
//                "stem", "left", "right", "inclination", "half inclination", "outline" (both
//                boundaries), "around" or "unsure". A stroke that continues or corrects an earlier
//                stroke is {"role": "left", "of": 2}, where 2 is the number, counted from 1, of the
//                earlier stroke
//   unplaced     [N, …]: the numbers, counted from 1, of strokes that are not used
//   notes        guesses that had to be made
//
// For a plant of several stems, the members from stem_length to boundaries are those of its first
// stem. The report then also has:
//
//   stems        [{…}, …]: for each stem, the members from stem_length to boundaries; stands_on,
//                the number of its parent stem, counted from 1, or null; and, if it has a parent,
//                stands_at, the place on the parent as a share of the parent's length
//   stroke_stems the number, counted from 1, of the stem to which each stroke belongs
std::string print_report(std::span<MeasuredStem const> stems, Plant const& plant,
                         LineDrawing const& drawing);

} // namespace tractus::lines
