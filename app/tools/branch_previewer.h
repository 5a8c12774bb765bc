#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::tools {

// Creates a preview for tools that reshape branches: it shows each branch that the stroke moves, in
// full and in its new position. Each update recomputes only the branches that the stroke touches
// and their descendants.
std::unique_ptr<StrokePreviewer> branch_previewer();

// Like branch_previewer(), but for a tool that reads the tips of the plant's existing strokes on
// every update. The preview loads these tips into memory once per scene.
std::unique_ptr<StrokePreviewer> stroke_reading_previewer();

} // namespace tractus::tools
