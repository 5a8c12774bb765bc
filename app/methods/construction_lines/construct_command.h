#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// tractus construct SKETCH -o DIR: a plant from construction lines.
void add_construct_command(CLI::App& root, Action& action);

} // namespace tractus
