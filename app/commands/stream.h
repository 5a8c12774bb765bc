#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::commands {

// Command `tractus stream [LOG]`: prints tips and strokes as lines for other programs.
void add_stream_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::commands
