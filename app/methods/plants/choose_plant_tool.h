#pragma once

#include "app/tools/tool.h"

namespace tractus {

// From here on what is drawn goes to the plant that the pen touches.
struct ChoosePlantTool {
    static ToolKind const kKind;
};

} // namespace tractus
