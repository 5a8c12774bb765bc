#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// tractus decode FILE [--csv [--raw] [-o FILE]]: what a device log's pens did.
void add_decode_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
