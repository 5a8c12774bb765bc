#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus derive MODEL.l`: derives a model's string and prints it or its symbols' counts.
void add_derive_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
