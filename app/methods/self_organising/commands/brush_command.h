#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::self_organising {

// Adds the command `tractus brush STROKES --habit oak --years 12 -o FILE`: grows a tree into the
// volume that a brush sweeps along strokes. With `--case CASE.json --report` instead, it runs a
// test case of the growth laws.
void add_brush_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::self_organising
