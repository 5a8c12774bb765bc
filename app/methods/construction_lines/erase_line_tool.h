#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Takes construction lines of the active plant away that the stroke runs over, and lines of its
// leaves.
struct EraseLineTool {
    static tools::ToolKind const kKind;

    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::lines
