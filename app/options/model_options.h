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

// Options that say which plant a command is about: MODEL, --steps and --seed mean the same
// everywhere.
struct ModelOptions {
    std::string model; // Name for find_model().
    std::optional<int> steps;
    std::optional<std::uint64_t> seed; // If there is none, 1 or what a session has.
};

// --view, --colors and --environment. `companions` must live as long as the command.
void add_companion_options(CLI::App& command, io::ModelCompanions& companions);

// Adds them to a command. `options` must live as long as the command.
void add_model_options(CLI::App& command, ModelOptions& options);

// --max-modules, --max-memory and --max-seconds: what a model may cost, alike in every command that
// runs one.
void add_cost_options(CLI::App& command, document::ModelCost& cost);

// How to derive the string of a model: its steps and its seed, and what it may cost from now on.
lsystem::DeriveOptions derive_options(ModelOptions const& model, document::ModelCost const& cost);

} // namespace tractus::options
