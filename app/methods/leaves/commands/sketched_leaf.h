#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::leaf {

// Adds the command `tractus leaves fit`. It makes a leaf grammar from a drawn leaf, given as a
// drawing (load_leaf_sketch()), a pen recording, or a file of strokes.
void add_sketch_leaf_command(CLI::App& leaves, options::Action& action,
                             tools::Methods const& methods);

} // namespace tractus::leaf
