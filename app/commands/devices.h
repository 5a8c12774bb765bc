#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus devices [--json]`: lists the machine's HID devices, with what the program can
// use each for.
void add_devices_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
