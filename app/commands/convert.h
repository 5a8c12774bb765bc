#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::commands {

// Command `tractus convert IN -o OUT`: converts other programs' recordings to logs of this program,
// logs to hid-recorder's format, and the strokes of recordings and logs to curves.
void add_convert_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::commands
