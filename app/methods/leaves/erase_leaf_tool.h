#pragma once

#include "app/tools/tool.h"

namespace tractus::leaf {

// Takes lines of the active leaf's drawing away that the stroke runs over.
struct EraseLeafTool {
    static tools::ToolKind const kKind;

    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::leaf
