#pragma once

#include "app/tools/methods.h"

namespace tractus::methods {

// The one list of everything this program can do. To add a tool or a kind of edit, add a row here.
tools::Methods all_methods();

} // namespace tractus::methods
