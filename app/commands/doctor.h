#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// `tractus doctor`: what keeps the devices from working, and what to do about it.
void add_doctor_command(CLI::App& root, options::Action& action);

} // namespace tractus::commands
