#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/recognise_line.h"

namespace tractus::lines {

// Sets the role of the construction line at which the stroke ends, or reverses that line.
struct LineRoleTool {
    static tools::ToolKind const kKind;

    lines::Role role = lines::Role::Inclination;
    bool turn_round = false; // Reverses the line, which keeps its role; `role` is not used.
};

} // namespace tractus::lines
