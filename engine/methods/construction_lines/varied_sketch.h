#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"

namespace tractus::lines {

// The sketch as another hand would have drawn it: the sheet under all of its lines is bent alike,
// in long waves, by a twenty-fifth of the stem's length where the spread is 1, and stays where the
// stem begins. So lines cross as they did, and organs reach as far as their lines. Layers have a
// tenth of their nodes more or less. The mean of many is the sketch.
PenSketch varied_sketch(PenSketch sketch, scene::SourceVariation const& variation);

} // namespace tractus::lines
