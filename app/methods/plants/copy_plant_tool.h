#pragma once

#include "app/tools/tool.h"

namespace tractus {

// Adds a plant like the active one, beside all others.
struct CopyPlantTool {
    static ToolKind const kKind;
};

} // namespace tractus
