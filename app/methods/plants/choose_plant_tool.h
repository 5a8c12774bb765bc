#pragma once

#include "app/tools/tool.h"

namespace tractus {

// Makes the plant that the pen touches take what is drawn from here on.
struct ChoosePlantTool {
    static ToolKind const kKind;
};

} // namespace tractus
