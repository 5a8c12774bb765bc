#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"

namespace tractus::lines {

// Varies a sketch as if drawn by another hand: the sheet is deformed in long waves by a
// twenty-fifth of the stem's length for spread 1, with the stem's base fixed. So lines still cross
// each other, and organs reach as far as their boundaries. A layer's number of nodes varies by a
// tenth of it (standard deviation). The mean over many variations is the original sketch.
PenSketch varied_sketch(PenSketch sketch, scene::SourceVariation const& variation);

} // namespace tractus::lines
