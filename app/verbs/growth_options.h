#pragma once

#include "app/drawing.h"

#include <CLI/CLI.hpp>

namespace tractus {

// "--growth NAME" and "--liking X": how a verb's plants grow. `growth` must live as long as the
// verb.
void add_growth_options(CLI::App& verb, GrowthOptions& growth);

// "--age X": how old they are, all alike. `age` must live as long as the verb.
void add_age_option(CLI::App& verb, double& age);

} // namespace tractus
