#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::commands {

// `tractus convert IN -o OUT`: recordings of other programs to ours, ours to hid-recorder's, and
// what was drawn in either to curves.
void add_convert_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::commands
