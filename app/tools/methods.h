#pragma once

#include "app/tools/layer.h"
#include "app/tools/tool_kind.h"
#include "engine/base/result.h"
#include "engine/scene/edit_kind.h"

#include <functional>
#include <span>

namespace CLI {
class App;
}

namespace tractus::tools {

struct Methods;

// Adds a command to the command line, whose callback sets what is to be done.
using AddCommand
    = void (*)(CLI::App& root, std::function<Result<void>()>& action, Methods const& methods);

// All that the ways to sketch bring to a program: a value that is made where the program begins and
// passed down. What the lists point to lives as long as the program.
struct Methods {
    scene::EditKinds edits {};
    ToolKinds tools {};
    Layers layers {};
    std::span<AddCommand const> commands {};
};

} // namespace tractus::tools
