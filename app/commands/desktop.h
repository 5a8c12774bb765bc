#pragma once

#include "app/options/action.h"

namespace tractus::commands {

// Two commands for the desktop's sake, which --help does not list: "complete", which the shells'
// scripts in app/desktop ask what may come next, and "man-pages", which the build asks for the
// manual pages.
void add_desktop_commands(CLI::App& root, options::Action& action);

} // namespace tractus::commands
