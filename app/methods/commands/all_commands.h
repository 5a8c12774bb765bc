#pragma once

#include "app/tools/methods.h"

namespace tractus::methods {

// The methods with all commands that they bring: what all_methods() is for editing, this is for the
// command line. It stands apart, so that code that only edits need not be linked with them.
tools::Methods with_commands(tools::Methods methods);

} // namespace tractus::methods
