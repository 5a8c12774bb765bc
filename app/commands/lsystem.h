#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus lsystem check MODEL [-n STEPS] [--seed N]`: reports whether a model can be read,
// which language features it uses, and how its string grows.
void add_lsystem_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
