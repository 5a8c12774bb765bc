#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::leaf {

// Adds the command `tractus leaves`, for leaf grammars.
void add_leaves_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::leaf
