#pragma once

#include "app/options/action.h"

namespace tractus::leaf {

// tractus leaves paint and tractus leaves list, below `leaves`.
void add_paint_commands(CLI::App& leaves, options::Action& action);

} // namespace tractus::leaf
