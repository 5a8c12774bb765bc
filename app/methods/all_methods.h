#pragma once

#include "app/tools/methods.h"

namespace tractus::methods {

// The one list of what this program can do. Whoever adds a tool or a kind of edit adds its row
// here.
tools::Methods all_methods();

} // namespace tractus::methods
