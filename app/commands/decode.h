#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus decode FILE [--csv [--raw] [-o FILE]]`: prints the decoded input of the pens in
// a device log.
void add_decode_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
