#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// tractus leaves: leaf grammars.
void add_leaves_command(CLI::App& root, Action& action);

} // namespace tractus
