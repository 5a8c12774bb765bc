#pragma once

#include "app/tools/tool.h"

namespace tractus::silhouette {

// Erases those lines in space of the active tree's crown that the stroke comes near.
struct EraseCrownTool {
    static tools::ToolKind const kKind;
    static constexpr double kRadius_mm = 8;
};

} // namespace tractus::silhouette
