#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Makes the plant that the pen touches the active one.
struct ChoosePlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
