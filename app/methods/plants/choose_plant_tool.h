#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Makes the plant under the stroke's end the active plant.
struct ChoosePlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
