#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus derive MODEL.l`: derives a model's string and prints the string or counts of its
// symbols.
void add_derive_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
