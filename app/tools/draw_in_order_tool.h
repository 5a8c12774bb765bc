#pragma once

#include "app/tools/tool.h"

namespace tractus {

// Each stroke shapes the next axis, the trunk first.
struct DrawInOrderTool {
    static ToolKind const kKind;
};

} // namespace tractus
