#pragma once

#include "app/tools/branch_place.h"
#include "app/tools/tool.h"

namespace tractus::plants {

// Puts the plant where the stroke begins on the branch of another where it ends.
struct GraftPlantTool {
    static tools::ToolKind const kKind;

    tools::Grafting grafting = tools::Grafting::Beside;
};

} // namespace tractus::plants
