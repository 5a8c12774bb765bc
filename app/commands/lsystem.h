#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// tractus lsystem check MODEL [-n STEPS] [--seed N]: whether a model is understood, what it uses of
// the language, and how its string grows.
void add_lsystem_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
