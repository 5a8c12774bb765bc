#pragma once

#include "engine/base/result.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace tractus::options {

// Adds options that several commands share, so that their names, checks and explanations are the
// same. A value that is already set is shown in the help as the default.

// Adds "--plant MODEL": a file or a built-in model.
CLI::Option* add_plant_option(CLI::App& command, std::string& model);

// Adds "--rig FILE": a calibration that replaces the log's.
CLI::Option* add_rig_option(CLI::App& command, std::string& file);

// Adds "--height MM|MOVEMENT": a height, or a movement, that replaces the height sensor.
CLI::Option* add_height_option(CLI::App& command, std::string& height);

// Parses --height for commands that read devices. Fails with a user error for a movement, which
// needs the length of the recording, unknown while it is live.
Result<double> constant_height_mm(std::string const& height);

// Adds "--seed N": the seed of the random variation.
CLI::Option* add_seed_option(CLI::App& command, std::uint64_t& seed);

// Adds "-o, --output FOLDER": the folder for a job's files. `Path` is std::filesystem::path or
// std::string.
template<typename Path> CLI::Option* add_folder_option(CLI::App& command, Path& folder)
{
    return command
        .add_option("-o,--output", folder,
                    "The folder for pictures, glTF and report; made if it is not there")
        ->type_name("FOLDER");
}

// Adds "--force", which lets a command overwrite files that the program did not make.
CLI::Option* add_force_option(CLI::App& command, bool& is_forced);

// Describes the files that a job writes, for the end of a command's help.
char const* job_footer();

} // namespace tractus::options
