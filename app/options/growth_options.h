#pragma once

#include "app/batch/drawing.h"
#include "engine/variation/individual.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace tractus::options {

// Adds "--growth NAME", "--variability X", "--leaves NAME" and the options of add_season_options(),
// which control how a command's plants grow. `without` is the end of a sentence in the help: how
// plants grow without --growth. `growth` must outlive the command.
void add_growth_options(CLI::App& command, batch::GrowthOptions& growth,
                        std::string const& without);

// Adds "--branches X", "--sizes X", "--turn X", "--younger X", "--leaf-size X" and "--own-seeds X",
// which control how much the plants of a collection differ from each other. `how` must outlive the
// command.
void add_individuality_options(CLI::App& command, variation::Individuality& how);

// Adds "--season WHEN" and "--fallen X", which select the time of year. `season` must outlive the
// command.
void add_season_options(CLI::App& command, std::optional<scene::Season>& season);

// Adds "--age X", the age of all plants. `age` must outlive the command.
void add_age_option(CLI::App& command, double& age);

} // namespace tractus::options
