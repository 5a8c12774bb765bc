#pragma once

#include "app/tools/tool.h"

namespace tractus::silhouette {

// Takes away what was drawn of the active tree where the stroke runs over it on paper.
struct EraseOutlineTool {
    static tools::ToolKind const kKind;
    static constexpr double kRadius_mm = 4;
};

} // namespace tractus::silhouette
