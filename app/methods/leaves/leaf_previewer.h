#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::leaf {

// For the tool that draws a leaf: the edge and the veins of the leaf as they would be if the line
// ended now; of an outline that comes back, as if the pen had got there.
std::unique_ptr<tools::StrokePreviewer> leaf_previewer();

} // namespace tractus::leaf
