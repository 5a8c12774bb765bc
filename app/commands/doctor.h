#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus doctor`: finds out why devices do not work, and what to do about it.
void add_doctor_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
