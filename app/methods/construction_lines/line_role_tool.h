#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/recognise_line.h"

namespace tractus::lines {

// Says what the line under the stroke's end is.
struct LineRoleTool {
    static tools::ToolKind const kKind;

    lines::Role role = lines::Role::Inclination;
    bool turn_round = false; // Instead of a role the line gets the other direction.
};

} // namespace tractus::lines
