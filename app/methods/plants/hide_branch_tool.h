#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Hides the selected branches, or shows all hidden branches of the active plant.
struct HideBranchTool {
    static tools::ToolKind const kKind;

    enum class What { Selected, None } what = What::Selected;
};

} // namespace tractus::plants
