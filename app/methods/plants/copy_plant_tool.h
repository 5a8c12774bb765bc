#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Adds a copy of the active plant to the right of all other plants.
struct CopyPlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
