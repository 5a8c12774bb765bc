#pragma once

#include "app/tools/layer.h"

namespace tractus {

// The construction lines of the active plant, where they stand before it: its stem,
extern Layer const kStemLayer;
// its boundaries,
extern Layer const kBoundaryLayer;
// its inclination lines, and halves of them,
extern Layer const kInclinationLayer;
// as much of every other stem, the second, the fourth and so on,
extern Layer const kOtherStemLayer;
extern Layer const kOtherBoundaryLayer;
extern Layer const kOtherInclinationLayer;
// those of which nobody knows what they are,
extern Layer const kUnsureLayer;
// and where lines that it lacks might be (lines_to_draw.h).
extern Layer const kLinesToDrawLayer;

} // namespace tractus
