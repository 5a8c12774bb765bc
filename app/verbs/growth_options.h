#pragma once

#include "app/job.h"

#include <CLI/CLI.hpp>

namespace tractus {

// "--growth NAME", "--liking X" and "--age X": how a verb's plants grow. `growth` must live as long
// as the verb.
void add_growth_options(CLI::App& verb, JobGrowth& growth);

} // namespace tractus
