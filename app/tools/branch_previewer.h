#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::tools {

// For tools that give branches another shape: the branches that stand elsewhere with the stroke
// than without it, where they stand then, and the whole branch each time. Only what the stroke
// touches, and what stands on it, is laid anew each time.
std::unique_ptr<StrokePreviewer> branch_previewer();

// The same for a tool that looks at the tips of all strokes that shape something, each time: they
// are read once.
std::unique_ptr<StrokePreviewer> stroke_reading_previewer();

} // namespace tractus::tools
