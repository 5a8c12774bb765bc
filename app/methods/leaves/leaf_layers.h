#pragma once

#include "app/tools/layer.h"

namespace tractus::leaf {

// Layer of the leaf's outline. Layers of a leaf show the lines of its drawing in place around it.
extern tools::Layer const kLeafOutlineLayer;
// Layer of the midrib, the veins and the petiole.
extern tools::Layer const kLeafVeinLayer;
// Layer of the lines that are ignored or do not make a leaf yet.
extern tools::Layer const kLeafOtherLayer;

} // namespace tractus::leaf
