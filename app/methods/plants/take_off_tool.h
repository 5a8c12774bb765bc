#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Makes a part that was put on a plant a plant of its own again.
struct TakeOffTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
