#pragma once

#include "app/tools/drawn_curve.h"
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

// Adds a subcommand to the command line. When parsed, the subcommand stores in `action` what to
// run.
using AddCommand
    = void (*)(CLI::App& root, std::function<Result<void>()>& action, Methods const& methods);

// Everything the sketching methods contribute to the program. Created at startup and passed down.
// The lists refer to objects that live as long as the program.
struct Methods {
    scene::EditKinds edits {};
    ToolKinds tools {};
    Layers layers {};
    DrawnCurveLists curves {};
    std::span<AddCommand const> commands {};
};

} // namespace tractus::tools
