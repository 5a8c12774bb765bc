#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Moves the plant on which the stroke begins along with the stroke, over the ground.
struct MovePlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
