#pragma once

#include "app/tools/layer.h"

namespace tractus::leaf {

// Layers show the lines of the active leaf's drawing where they stand around it. This one shows the
// outline.
extern tools::Layer const kLeafOutlineLayer;
// Layer of the midrib, the veins and the petiole.
extern tools::Layer const kLeafVeinLayer;
// Layer of the lines that are ignored or do not make a leaf yet.
extern tools::Layer const kLeafOtherLayer;

} // namespace tractus::leaf
