#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// "tractus sim gadget"; `sim` is the verb above.
void add_sim_gadget_verb(CLI::App& sim, Action& action);

} // namespace tractus
