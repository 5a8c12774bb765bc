#pragma once

#include "app/tools/tool.h"

namespace tractus::silhouette {

// Erases the lines of the active tree's drawing that the stroke crosses on the paper.
struct EraseOutlineTool {
    static tools::ToolKind const kKind;
    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::silhouette
