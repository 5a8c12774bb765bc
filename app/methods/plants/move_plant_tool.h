#pragma once

#include "app/tools/tool.h"

namespace tractus {

// The plant where the stroke begins goes along with it, over the ground.
struct MovePlantTool {
    static ToolKind const kKind;
};

} // namespace tractus
