#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"

namespace tractus::lines {

// Varies a sketch as if it had been drawn by another hand. The sheet is deformed in long waves; for
// spread 1 their amplitude is a twenty-fifth of the stem's length. The stem's base stays in place.
// Because lines are deformed together, they still cross each other, and organs reach as far as
// their boundaries. The number of nodes of each layer varies with a standard deviation of a tenth
// of it. The mean over many variations is the original sketch.
PenSketch varied_sketch(PenSketch sketch, scene::SourceVariation const& variation);

} // namespace tractus::lines
