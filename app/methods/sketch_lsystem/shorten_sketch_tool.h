#pragma once

#include "app/tools/tool.h"

namespace tractus::sketch {

// Shortens the stroke along which the active plant has grown, or the newest of its grafted parts
// that grew along a stroke. The stroke then ends where the eraser crosses its axis. If the eraser
// touches strokes or indicators on the plant, it erases these instead.
struct ShortenSketchTool {
    static tools::ToolKind const kKind;
    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::sketch
