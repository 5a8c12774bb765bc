#pragma once

#include "app/verbs/verb.h"

namespace tractus {

// Two verbs for the desktop's sake, which --help does not list: "complete", which the shells'
// scripts in app/desktop ask what may come next, and "man-pages", which the build asks for the
// manual pages.
void add_desktop_verbs(CLI::App& root, Action& action);

} // namespace tractus
