#pragma once

#include "app/options/action.h"

namespace tractus::leaf {

// Adds the commands `tractus leaves paint` and `tractus leaves list`.
void add_paint_commands(CLI::App& leaves, options::Action& action);

} // namespace tractus::leaf
