#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Each stroke shapes the next axis, the trunk first.
struct DrawInOrderTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
