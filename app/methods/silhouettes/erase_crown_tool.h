#pragma once

#include "app/tools/tool.h"

namespace tractus::silhouette {

// Erases the lines of the active tree's crown in space that the stroke comes near.
struct EraseCrownTool {
    static tools::ToolKind const kKind;
    static constexpr double kRadius_mm = 8;
};

} // namespace tractus::silhouette
