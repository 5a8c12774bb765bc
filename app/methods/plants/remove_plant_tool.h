#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Removes the active plant and everything that was drawn on it.
struct RemovePlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
