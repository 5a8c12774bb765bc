#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// tractus lsystem check MODEL [-n STEPS] [--seed N]: whether a model is understood, what it uses of
// the language, and how its string grows.
void add_lsystem_verb(CLI::App& root, Action& action);

} // namespace tractus
