#pragma once

#include "app/tools/tool.h"

namespace tractus {

// The indicator where the stroke begins goes.
struct DeleteIndicatorTool {
    static ToolKind const kKind;
};

} // namespace tractus
