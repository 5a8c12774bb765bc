#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Hides the branches that are selected, or shows all that are hidden on the active plant.
struct HideBranchTool {
    static tools::ToolKind const kKind;

    enum class What { Selected, None } what = What::Selected;
};

} // namespace tractus::plants
