#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Adds two commands that --help does not list: "complete", used by the shell completion scripts in
// app/desktop, and "man-pages", used by the build to generate the manual pages.
void add_desktop_commands(CLI::App& root, options::Action& action);

} // namespace tractus::commands
