#pragma once

#include "app/tools/tool.h"

namespace tractus::indicators {

// The indicator where the stroke begins goes.
struct DeleteIndicatorTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::indicators
