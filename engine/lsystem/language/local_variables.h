#pragma once

#include "engine/lsystem/language/model.h"

namespace tractus::lsystem {

// Returns true if a rule may read this local variable before it sets it, so that the value from the
// rule's previous match matters.
bool is_read_before_set(Rule const& rule, Register variable);

} // namespace tractus::lsystem
