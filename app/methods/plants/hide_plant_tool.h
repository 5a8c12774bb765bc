#pragma once

#include "app/tools/tool.h"

namespace tractus {

// Hides the active plant, or shows all that are hidden.
struct HidePlantTool {
    static ToolKind const kKind;

    enum class What { Active, None } what = What::Active;
};

} // namespace tractus
