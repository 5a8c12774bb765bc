#pragma once

#include "app/tools/layer.h"

namespace tractus::leaf {

// Layer of the leaf's outline. The layers of this file show the lines of a leaf's drawing where
// they are on the paper.
extern tools::Layer const kLeafOutlineLayer;
// Layer of the leaf's midrib, veins and petiole.
extern tools::Layer const kLeafVeinLayer;
// Layer of a leaf's lines that are ignored or do not make a leaf yet.
extern tools::Layer const kLeafOtherLayer;

} // namespace tractus::leaf
