#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::leaf {

// tractus leaves: leaf grammars.
void add_leaves_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::leaf
