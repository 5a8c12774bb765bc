#pragma once

#include "app/tools/methods.h"

namespace tractus::methods {

// Adds the subcommands of all methods to `methods`. This function is separate from all_methods(),
// so that code without a command line need not be linked with the subcommands.
tools::Methods with_commands(tools::Methods methods);

} // namespace tractus::methods
