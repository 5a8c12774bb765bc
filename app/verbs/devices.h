#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// tractus devices [--json]: the HID devices that this machine has, and what they are to the
// station.
void add_devices_verb(CLI::App& root, Action& action);

} // namespace tractus
