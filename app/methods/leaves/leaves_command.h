#pragma once

#include "app/tools/methods.h"
#include "app/verbs/verb.h"

namespace tractus {

// tractus leaves: leaf grammars.
void add_leaves_command(CLI::App& root, Action& action, Methods const& methods);

} // namespace tractus
