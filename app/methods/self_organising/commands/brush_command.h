#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::self_organising {

// Command `tractus brush STROKES --habit oak --years 12 -o FILE`: a tree grows into the volume that
// a brush sweeps along strokes. `tractus brush --case CASE.json --report` runs a test case of the
// growth laws alone.
void add_brush_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::self_organising
