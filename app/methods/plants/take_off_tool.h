#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Detaches the touched plant from the branch onto which it was grafted, so that it is independent
// again.
struct TakeOffTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
