#pragma once

#include "app/tools/methods.h"

namespace tractus::methods {

// Adds the methods' subcommands for the command line to `methods`. Kept apart from all_methods(),
// so that code that only edits need not be linked with the commands.
tools::Methods with_commands(tools::Methods methods);

} // namespace tractus::methods
