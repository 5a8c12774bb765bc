#pragma once

#include "app/tools/methods.h"

namespace tractus {

// The methods with all commands that they bring: what all_methods() is to who edits, this is to the
// command line. Apart from it, since what only edits need not be linked with them.
Methods with_commands(Methods methods);

} // namespace tractus
