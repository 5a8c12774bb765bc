#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// tractus sketch STROKE -o DIR: a rule grows along a drawn stroke.
void add_sketch_command(CLI::App& root, Action& action);

} // namespace tractus
