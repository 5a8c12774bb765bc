#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Deletes the last stroke of the selected branches.
struct DeleteTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
