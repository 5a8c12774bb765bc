#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// tractus calibrate height|travel|latency|tilt|zero|check: finds out a rig's numbers, or how good
// they are, and keeps them in its file.
void add_calibrate_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
