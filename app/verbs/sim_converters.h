#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// "tractus sim mcp2221a", "desk", "cp2112" and "encoder"; `sim` is the verb above.
void add_sim_converter_verbs(CLI::App& sim, Action& action);

} // namespace tractus
