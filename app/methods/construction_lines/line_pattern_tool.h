#pragma once

#include "app/tools/tool.h"

namespace tractus {

// The next pattern for the active plant's organs.
struct LinePatternTool {
    static ToolKind const kKind;
};

} // namespace tractus
