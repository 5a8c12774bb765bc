#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::silhouette {

// Adds the command `tractus silhouette FILE … -o OUTPUT`: makes a tree from the outline of its
// crown.
void add_silhouette_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::silhouette
