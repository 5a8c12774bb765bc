#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Detaches a plant that was grafted onto another, making it independent again.
struct TakeOffTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
