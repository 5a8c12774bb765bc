#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// `tractus convert IN -o OUT`: recordings of other programs to ours, and ours to hid-recorder's.
void add_convert_verb(CLI::App& root, Action& action);

} // namespace tractus
