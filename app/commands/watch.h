#pragma once

#include "app/options/action.h"

namespace tractus {

// `tractus watch [DEVICE...]`: what devices send, live in the terminal.
void add_watch_command(CLI::App& root, Action& action);

} // namespace tractus
