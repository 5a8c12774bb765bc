#pragma once

#include "app/tools/methods.h"

namespace tractus::commands {

// Runs the program with the given methods: parses the command line and runs the command. Returns
// the exit code: 0 for success, 1 for a failure that a message on standard error explains, 2 for
// wrong usage.
int run_command_line(int argc, char const* const* argv, tools::Methods const& methods);

} // namespace tractus::commands
