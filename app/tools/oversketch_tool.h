#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Redraws a part of the newest of the strokes that shape the selected branches.
struct OversketchTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
