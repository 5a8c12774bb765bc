#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus calibrate height|travel|latency|tilt|zero|check`: determines a rig's parameters,
// or checks their accuracy, and saves them in its file.
void add_calibrate_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
