#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Smooths the strokes that shape the selected branches, removing the hand's tremor.
struct SmoothTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
