#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::sketch {

// Command `tractus sketch STROKE -o DIR`: a rule grows a plant along a drawn stroke.
void add_sketch_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::sketch
