#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Hides the active plant, or shows all hidden plants.
struct HidePlantTool {
    static tools::ToolKind const kKind;

    enum class What { Active, None } what = What::Active;
};

} // namespace tractus::plants
