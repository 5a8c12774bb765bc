#pragma once

#include "app/options/action.h"

namespace tractus::commands {

void add_sim_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
