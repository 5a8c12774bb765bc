#pragma once

#include "app/options/action.h"

namespace tractus {

void add_sim_command(CLI::App& root, Action& action);

} // namespace tractus
