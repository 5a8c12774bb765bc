#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus {

void add_replay_command(CLI::App& root, Action& action, Methods const& methods);

} // namespace tractus
