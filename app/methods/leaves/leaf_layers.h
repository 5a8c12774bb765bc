#pragma once

#include "app/tools/layer.h"

namespace tractus::leaf {

// The lines of the active leaf's drawing, where they stand around it: its outline,
extern tools::Layer const kLeafOutlineLayer;
// its midrib, veins and stalk,
extern tools::Layer const kLeafVeinLayer;
// and those that are left out, or no leaf yet.
extern tools::Layer const kLeafOtherLayer;

} // namespace tractus::leaf
