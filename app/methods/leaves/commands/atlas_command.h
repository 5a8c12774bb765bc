#pragma once

#include "app/options/action.h"

namespace tractus::leaf {

// Adds `tractus leaves LEAF... -o DIR`, which writes pages of leaves (atlases) for game engines.
void add_atlas_options(CLI::App& leaves, options::Action& action);

// Adds examples to these commands, after all other commands below `leaves`.
void add_atlas_examples(CLI::App& leaves);

} // namespace tractus::leaf
