#pragma once

#include "app/document/model_cost.h"
#include "app/plants/model_file.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tractus {

// Options that say which plant a verb is about: MODEL, --steps and --seed mean the same everywhere.
struct ModelOptions {
    std::string model; // Name for find_model().
    std::optional<int> steps;
    std::optional<std::uint64_t> seed; // If there is none, 1 or what a session has.
};

// --view, --colors and --environment. `companions` must live as long as the verb.
void add_companion_options(CLI::App& verb, ModelCompanions& companions);

// Adds them to a verb. `options` must live as long as the verb.
void add_model_options(CLI::App& verb, ModelOptions& options);

// --max-modules, --max-memory and --max-seconds: what a model may cost, alike in every verb that
// runs one.
void add_cost_options(CLI::App& verb, ModelCost& cost);

} // namespace tractus
