#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// `tractus watch [DEVICE...]`: what devices send, live in the terminal.
void add_watch_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
