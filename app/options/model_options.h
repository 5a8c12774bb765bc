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

// The options that select a command's plant; MODEL, --steps and --seed mean the same in every
// command.
struct ModelOptions {
    std::string model; // Name or path of the model, for find_model().
    std::optional<int> steps;
    std::optional<std::uint64_t> seed; // Default: the session's seed, or 1.
};

// Adds --view, --colors, --environment and --dialect. `companions` must outlive the command.
void add_companion_options(CLI::App& command, io::ModelCompanions& companions);

// Adds MODEL, --steps and --seed to a command. `options` must outlive the command.
void add_model_options(CLI::App& command, ModelOptions& options);

// Adds --max-modules, --max-memory and --max-seconds, which limit what a model may cost, to any
// command that runs models.
void add_cost_options(CLI::App& command, document::ModelCost& cost);

// How to derive a model's string: number of steps, seed, and limits; its time counts from now.
lsystem::DeriveOptions derive_options(ModelOptions const& model, document::ModelCost const& cost);

} // namespace tractus::options
