#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// "tractus sim mcp2221a" and "tractus sim cp2112"; `sim` is the verb above.
void add_sim_converter_verbs(CLI::App& sim, Action& action);

} // namespace tractus
