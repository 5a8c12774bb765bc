#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::tools {

// Preview for tools that reshape branches: shows each branch that the stroke moves, as a whole and
// in its new place. Each update recomputes only the branches that the stroke touches and their
// descendants.
std::unique_ptr<StrokePreviewer> branch_previewer();

// Like branch_previewer(), for a tool that needs the tips of all shaping strokes on every update;
// they are read only once.
std::unique_ptr<StrokePreviewer> stroke_reading_previewer();

} // namespace tractus::tools
