#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::lines {

// Adds the command `tractus construct SKETCH -o DIR`: makes a plant from construction lines.
void add_construct_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::lines
