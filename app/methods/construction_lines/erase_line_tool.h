#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Erases those construction lines of the active plant, and lines of its drawn leaves, that the
// stroke crosses.
struct EraseLineTool {
    static tools::ToolKind const kKind;

    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::lines
