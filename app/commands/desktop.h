#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Adds two commands that --help does not list. The shell completion scripts in app/desktop call
// "complete"; the build calls "man-pages" to generate the manual pages.
void add_desktop_commands(CLI::App& root, options::Action& action);

} // namespace tractus::commands
