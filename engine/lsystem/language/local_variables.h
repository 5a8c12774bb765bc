#pragma once

#include "engine/lsystem/language/model.h"

namespace tractus::lsystem {

// Whether a match of the rule may read this local variable before it has set it: then it finds what
// the last match left there. True as well where that would take too long to find out.
bool is_read_before_set(Rule const& rule, Register variable);

} // namespace tractus::lsystem
