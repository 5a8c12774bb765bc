#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// tractus devices [--json]: the HID devices that this machine has, and what they are to the
// station.
void add_devices_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
