#pragma once

#include "app/options/action.h"

namespace tractus::leaf {

// tractus leaves LEAF... -o DIR: pages of leaves for game engines.
void add_atlas_options(CLI::App& leaves, options::Action& action);

} // namespace tractus::leaf
