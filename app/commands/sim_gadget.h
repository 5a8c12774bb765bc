#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// "tractus sim gadget"; `sim` is the command above.
void add_sim_gadget_command(CLI::App& sim, options::Action& action);

} // namespace tractus::commands
