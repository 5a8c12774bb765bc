#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/recognise_line.h"

namespace tractus {

// Says what the line under the stroke's end is.
struct LineRoleTool {
    static ToolKind const kKind;

    lines::Role role = lines::Role::Inclination;
};

} // namespace tractus
