#pragma once

#include "app/tools/tool.h"

namespace tractus::sketch {

// Shortens the stroke along which the active plant, or its newest part with such a stroke, has
// grown: the stroke ends where the eraser crosses the axis. Strokes and indicators on the plant
// there are erased first.
struct ShortenSketchTool {
    static tools::ToolKind const kKind;
    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::sketch
