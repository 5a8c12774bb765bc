#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::commands {

void add_window_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

// Adds "tour": the window on an empty sheet, with a tour of the program (controllers/tour.h).
void add_tour_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::commands
