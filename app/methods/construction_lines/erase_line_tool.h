#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Removes the construction lines of the active plant, and the lines of its leaves, that the stroke
// crosses.
struct EraseLineTool {
    static tools::ToolKind const kKind;

    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::lines
