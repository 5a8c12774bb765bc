#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Adds "tractus sim gadget" to the command `sim`.
void add_sim_gadget_command(CLI::App& sim, options::Action& action);

} // namespace tractus::commands
