#pragma once

#include "app/document/model_cost.h"
#include "app/io/model_file.h"
#include "engine/lsystem/derivation/derive.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tractus::options {

// The options that select a command's plant. MODEL, --steps and --seed have the same meaning in
// every command.
struct ModelOptions {
    std::string model; // Name or path of the model, for find_model().
    std::optional<int> steps;
    // Seed of the derivation; no value: the session's seed, or 1.
    std::optional<std::uint64_t> seed;
};

// Adds --view, --colors, --environment and --dialect. `companions` must outlive the command.
void add_companion_options(CLI::App& command, io::ModelCompanions& companions);

// Adds MODEL, --steps and --seed to a command. `options` must outlive the command.
void add_model_options(CLI::App& command, ModelOptions& options);

// Adds --max-modules, --max-memory and --max-seconds, which limit the cost of a model, to a command
// that runs models.
void add_cost_options(CLI::App& command, document::ModelCost& cost);

// Returns how to derive a model's string: number of steps, seed, and limits. The limit of time
// counts from this call.
lsystem::DeriveOptions derive_options(ModelOptions const& model, document::ModelCost const& cost);

} // namespace tractus::options
