#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Adds a plant like the active one, beside all others.
struct CopyPlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
