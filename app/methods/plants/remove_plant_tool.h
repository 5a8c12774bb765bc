#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Takes the active plant away with all that was drawn on it.
struct RemovePlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
