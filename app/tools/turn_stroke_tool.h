#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Reverses the newest of the strokes that shape the selected branches: its tip becomes its foot.
struct TurnStrokeTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
