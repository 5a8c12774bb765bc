#pragma once

#include "app/tools/tool.h"

namespace tractus::indicators {

// Deletes the motion indicator on which the stroke begins.
struct DeleteIndicatorTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::indicators
