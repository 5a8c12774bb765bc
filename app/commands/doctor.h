#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Command `tractus doctor`: finds out why devices do not work, and says how to mend it.
void add_doctor_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
