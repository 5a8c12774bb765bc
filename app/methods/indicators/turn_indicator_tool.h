#pragma once

#include "app/tools/tool.h"

namespace tractus::indicators {

// Reverses the motion indicator on which the stroke begins: it points the other way.
struct TurnIndicatorTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::indicators
