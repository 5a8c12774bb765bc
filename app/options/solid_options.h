#pragma once

#include "app/batch/plant_format.h"

#include <CLI/CLI.hpp>
#include <filesystem>

namespace tractus::options {

// Adds "--watertight", "--least-thickness MM", "--print-height MM" and "--without-leaves", which
// make plants solid for printing, in .stl and .ply files.
void add_solid_options(CLI::App& command, batch::SolidFileOptions& options);

// Fails with a user error if such options were given for a file that they do not concern.
Result<void> check_solid_options(batch::SolidFileOptions const& options,
                                 std::filesystem::path const& output);

} // namespace tractus::options
