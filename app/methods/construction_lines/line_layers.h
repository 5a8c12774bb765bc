#pragma once

#include "app/tools/layer.h"

namespace tractus::lines {

// The construction lines of the active plant, where they stand before it: its stem,
extern tools::Layer const kStemLayer;
// its boundaries,
extern tools::Layer const kBoundaryLayer;
// its inclination lines, and halves of them,
extern tools::Layer const kInclinationLayer;
// as much of every other stem, the second, the fourth and so on,
extern tools::Layer const kOtherStemLayer;
extern tools::Layer const kOtherBoundaryLayer;
extern tools::Layer const kOtherInclinationLayer;
// those of which nobody knows what they are, and leaves that were drawn in three views,
extern tools::Layer const kUnsureLayer;
extern tools::Layer const kOrganLayer; // Of leaves that were drawn in three views.
// and where lines that it lacks might be (lines_to_draw.h).
extern tools::Layer const kLinesToDrawLayer;

} // namespace tractus::lines
