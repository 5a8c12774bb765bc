#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Deletes the newest of the strokes that shape the selected branches.
struct DeleteTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
