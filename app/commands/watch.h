#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus watch [DEVICE...]`: shows live in the terminal what devices send.
void add_watch_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
