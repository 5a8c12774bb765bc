#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::leaf {

// Creates a preview for drawing a leaf: the leaf's edge and veins as if the current line ended now.
// If the first line of a leaf is on its way back to its start, it is closed.
std::unique_ptr<tools::StrokePreviewer> leaf_previewer();

} // namespace tractus::leaf
