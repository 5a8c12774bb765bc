#pragma once

#include "engine/lsystem/language/model.h"

namespace tractus::lsystem {

// Returns true if a rule may read this local variable before setting it, so that the value of the
// rule's last match matters. Also true if the analysis would take too long.
bool is_read_before_set(Rule const& rule, Register variable);

} // namespace tractus::lsystem
