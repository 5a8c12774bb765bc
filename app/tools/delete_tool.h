#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// Takes the selected branches' last stroke away.
struct DeleteTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
