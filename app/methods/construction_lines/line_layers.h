#pragma once

#include "app/tools/layer.h"

namespace tractus::lines {

// Layer of the stem lines of the active plant's first, third, fifth stem and so on. The layers of
// this file show construction lines on the plant's sheet, in front of the plant.
extern tools::Layer const kStemLayer;
// Layer of the boundaries (the outlines that organs reach) of the first, third, fifth stem and so
// on.
extern tools::Layer const kBoundaryLayer;
// Layer of the inclination and half inclination lines of the first, third, fifth stem and so on.
extern tools::Layer const kInclinationLayer;
// The same three layers for the other stems, in other colours.
extern tools::Layer const kOtherStemLayer;
extern tools::Layer const kOtherBoundaryLayer;
extern tools::Layer const kOtherInclinationLayer;
// Layer of the construction lines whose role is not known.
extern tools::Layer const kUnsureLayer;
extern tools::Layer const kOrganLayer; // Layer of the lines of leaves drawn in three views.
// Layer that suggests where lines that the sketch lacks could be drawn (lines_to_draw.h).
extern tools::Layer const kLinesToDrawLayer;

} // namespace tractus::lines
