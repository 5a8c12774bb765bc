#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::commands {

void add_tools_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::commands
