#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::leaf {

// Previews the leaf while a line is drawn: its edge and veins as if the line ended now. An outline
// on its way back is treated as complete.
std::unique_ptr<tools::StrokePreviewer> leaf_previewer();

} // namespace tractus::leaf
