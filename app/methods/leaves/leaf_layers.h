#pragma once

#include "app/tools/layer.h"

namespace tractus {

// The lines of the active leaf's drawing, where they stand around it: its outline,
extern Layer const kLeafOutlineLayer;
// its midrib, veins and stalk,
extern Layer const kLeafVeinLayer;
// and those that are left out, or no leaf yet.
extern Layer const kLeafOtherLayer;

} // namespace tractus
