#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus devices [--json]`: lists the machine's HID devices and their roles for the
// program.
void add_devices_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
