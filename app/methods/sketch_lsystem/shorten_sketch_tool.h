#pragma once

#include "app/tools/tool.h"

namespace tractus::sketch {

// Takes the end of the stroke away along which the active plant, or the newest part of it that has,
// has grown: from where the eraser runs over its axis. What was drawn on the plant there is erased
// first.
struct ShortenSketchTool {
    static tools::ToolKind const kKind;
    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::sketch
