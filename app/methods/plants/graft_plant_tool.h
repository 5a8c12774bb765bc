#pragma once

#include "app/tools/branch_place.h"
#include "app/tools/tool.h"

namespace tractus {

// Puts the plant where the stroke begins on the branch of another where it ends.
struct GraftPlantTool {
    static ToolKind const kKind;

    Grafting grafting = Grafting::Beside;
};

} // namespace tractus
