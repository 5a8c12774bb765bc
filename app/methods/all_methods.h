#pragma once

#include "app/tools/methods.h"

namespace tractus::methods {

// All tools, edits, layers and commands of this program. A new tool or kind of edit needs an entry
// in the tables of this function's file.
tools::Methods all_methods();

} // namespace tractus::methods
