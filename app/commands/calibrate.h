#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus calibrate height|travel|latency|tilt|zero|check`: determines a rig's parameters
// and saves them in the rig's file; "check" reports how accurate they are.
void add_calibrate_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
