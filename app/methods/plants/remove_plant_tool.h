#pragma once

#include "app/tools/tool.h"

namespace tractus {

// Takes the active plant away with all that was drawn on it.
struct RemovePlantTool {
    static ToolKind const kKind;
};

} // namespace tractus
