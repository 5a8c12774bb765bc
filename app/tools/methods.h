#pragma once

#include "app/tools/tool_kind.h"
#include "engine/scene/edit_kind.h"

namespace tractus {

// All that the ways to sketch bring to a program: a value that is made where the program begins and
// passed down. What the lists point to lives as long as the program.
struct Methods {
    EditKinds edits;
    ToolKinds tools;
};

} // namespace tractus
