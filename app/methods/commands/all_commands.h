#pragma once

#include "app/tools/methods.h"

namespace tractus {

// The methods with all commands that they bring: what all_methods() is for editing, this is for the
// command line. It stands apart, so that code that only edits need not be linked with them.
Methods with_commands(Methods methods);

} // namespace tractus
