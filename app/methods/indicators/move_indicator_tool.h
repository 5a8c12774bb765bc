#pragma once

#include "app/tools/tool.h"

namespace tractus {

// The indicator where the stroke begins goes along with it.
struct MoveIndicatorTool {
    static ToolKind const kKind;
};

} // namespace tractus
