#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::leaf {

// "fit" among the commands of leaves: makes a grammar's file of a leaf that was drawn, from a
// drawing (load_leaf_sketch), a recording of a pen, or a file of strokes.
void add_sketch_leaf_command(CLI::App& leaves, options::Action& action,
                             tools::Methods const& methods);

} // namespace tractus::leaf
