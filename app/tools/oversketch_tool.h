#pragma once

#include "app/tools/tool.h"

namespace tractus::tools {

// The stroke redraws a part of the selected branches' newest one.
struct OversketchTool {
    static ToolKind const kKind;
};

} // namespace tractus::tools
