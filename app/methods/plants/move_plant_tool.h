#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// The plant where the stroke begins goes along with it, over the ground.
struct MovePlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
