#pragma once

#include "app/tools/tool.h"

namespace tractus::leaf {

// Erases the lines of the active leaf's drawing that the stroke crosses.
struct EraseLeafTool {
    static tools::ToolKind const kKind;

    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::leaf
