#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Adds the commands "tractus sim mcp2221a", "desk", "cp2112" and "encoder" to the command `sim`.
void add_sim_converter_commands(CLI::App& sim, options::Action& action);

} // namespace tractus::commands
