#pragma once

#include "app/tools/layer.h"

namespace tractus::lines {

// Layer of the active plant's first stem, third stem and so on. Layers of construction lines show
// them on the plant's sheet, in front of the plant.
extern tools::Layer const kStemLayer;
// Layer of the boundaries (the outlines that organs reach).
extern tools::Layer const kBoundaryLayer;
// Layer of the inclination lines and half inclination lines.
extern tools::Layer const kInclinationLayer;
// Layers of every second stem, in another colour: its stem line, boundaries and inclination lines.
extern tools::Layer const kOtherStemLayer;
extern tools::Layer const kOtherBoundaryLayer;
extern tools::Layer const kOtherInclinationLayer;
// Layer of the lines whose role is not known.
extern tools::Layer const kUnsureLayer;
extern tools::Layer const kOrganLayer; // Layer of leaves drawn in three views.
// Layer that suggests where missing lines could be drawn (lines_to_draw.h).
extern tools::Layer const kLinesToDrawLayer;

} // namespace tractus::lines
