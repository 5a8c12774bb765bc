#pragma once

#include "app/batch/drawing.h"
#include "engine/variation/individual.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace tractus::options {

// "--growth NAME", "--variability X", "--leaves NAME" and the season's options: how a command's
// plants grow. `without` ends a sentence: how they grow without a name. `growth` must live as long
// as the command.
void add_growth_options(CLI::App& command, batch::GrowthOptions& growth,
                        std::string const& without);

// "--branches X", "--size X" and "--turn X": how much the plants of a collection are individuals.
// `how` must live as long as the command.
void add_individuality_options(CLI::App& command, variation::Individuality& how);

// "--season WHEN" and "--fallen X": the time of the year. `season` must live as long as the
// command.
void add_season_options(CLI::App& command, std::optional<scene::Season>& season);

// "--age X": how old they are, all alike. `age` must live as long as the command.
void add_age_option(CLI::App& command, double& age);

} // namespace tractus::options
