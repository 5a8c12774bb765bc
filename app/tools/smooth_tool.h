#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Takes the hand out of the selected branches' strokes.
struct SmoothTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
