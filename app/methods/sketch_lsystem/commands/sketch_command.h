#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::sketch {

// Adds the command `tractus sketch STROKE -o DIR`: grows a plant by a rule along a drawn stroke.
void add_sketch_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::sketch
