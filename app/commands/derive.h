#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// tractus derive MODEL.l: rewrites a model's string and prints it, or what it consists of.
void add_derive_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
