#pragma once

#include "app/tools/methods.h"

namespace tractus::commands {

// The whole program, with these methods: parses the command line, runs the command it names, and
// returns the exit code: 0 done, 1 a failure that a line on standard error explains, 2 wrong usage.
int run_command_line(int argc, char const* const* argv, tools::Methods const& methods);

} // namespace tractus::commands
