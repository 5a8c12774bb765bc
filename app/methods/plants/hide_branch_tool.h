#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Hides the selected branches of the active plant, or shows all its hidden branches.
struct HideBranchTool {
    static tools::ToolKind const kKind;

    enum class What { Selected, None } what = What::Selected;
};

} // namespace tractus::plants
