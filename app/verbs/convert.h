#pragma once

#include "app/tools/methods.h"
#include "app/verbs/verb.h"

namespace tractus {

// `tractus convert IN -o OUT`: recordings of other programs to ours, ours to hid-recorder's, and
// what was drawn in either to curves.
void add_convert_verb(CLI::App& root, Action& action, Methods const& methods);

} // namespace tractus
