#pragma once

#include "app/tools/branch_place.h"
#include "app/tools/tool.h"

namespace tractus::plants {

// Grafts the plant on which the stroke begins onto the branch of another plant on which the stroke
// ends.
struct GraftPlantTool {
    static tools::ToolKind const kKind;

    tools::Grafting grafting = tools::Grafting::Beside;
};

} // namespace tractus::plants
