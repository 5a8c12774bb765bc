#pragma once

#include "app/tools/methods.h"

namespace tractus::commands {

// Runs the whole program with these methods: parses the command line, runs the command, and returns
// the exit code: 0 success, 1 a failure that a message on standard error explains, 2 wrong usage.
int run_command_line(int argc, char const* const* argv, tools::Methods const& methods);

} // namespace tractus::commands
