#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// `tractus watch [DEVICE...]`: what devices send, live in the terminal.
void add_watch_verb(CLI::App& root, Action& action);

} // namespace tractus
