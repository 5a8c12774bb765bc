#pragma once

#include "app/tools/tool.h"

namespace tractus::indicators {

// Moves the motion indicator on which the stroke begins along with the stroke.
struct MoveIndicatorTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::indicators
