#pragma once

#include "app/tools/tool.h"

namespace tractus::indicators {

// Moves the motion indicator on which the stroke begins, by the vector from the stroke's start to
// its end.
struct MoveIndicatorTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::indicators
