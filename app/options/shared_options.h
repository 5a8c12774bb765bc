#pragma once

#include "engine/base/result.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace tractus::options {

// The options that several commands have, declared once, so that they are named, checked and
// explained alike. Where the value is already set, the help shows it as the default.

// "--plant MODEL": a file or one of our models.
CLI::Option* add_plant_option(CLI::App& command, std::string& model);

// "--rig FILE": a calibration in place of the one in the log.
CLI::Option* add_rig_option(CLI::App& command, std::string& file);

// "--height MM|MOVEMENT": a height in place of the height sensor's.
CLI::Option* add_height_option(CLI::App& command, std::string& height);

// Returns such a height while devices are read. Fails, as the user's fault, for a movement: nobody
// knows how long it would have to last.
Result<double> constant_height_mm(std::string const& height);

// "--seed N": of the variations.
CLI::Option* add_seed_option(CLI::App& command, std::uint64_t& seed);

// "-o, --output FOLDER": where a job's files go; `Path` is std::filesystem::path or std::string.
template<typename Path> CLI::Option* add_folder_option(CLI::App& command, Path& folder)
{
    return command
        .add_option("-o,--output", folder,
                    "The folder for pictures, glTF and report; made if it is not there")
        ->type_name("FOLDER");
}

// "--force": write over files that the program did not make.
CLI::Option* add_force_option(CLI::App& command, bool& is_forced);

// Says what a job writes, for the end of a command's help.
char const* job_footer();

} // namespace tractus::options
