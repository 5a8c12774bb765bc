#pragma once

#include "app/tools/tool.h"

namespace tractus::plants {

// Moves the plant on which the stroke begins over the ground, along with the stroke.
struct MovePlantTool {
    static tools::ToolKind const kKind;
};

} // namespace tractus::plants
