#pragma once

#include "app/batch/drawing.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace tractus::options {

// Values of the options for a drawing, which a command draws on its plant.
struct DrawingArguments {
    std::string log; // File name of the drawing; empty if there is none.
    std::string rig;
    std::string height;
};

// Adds "--drawing LOG", "--rig FILE" and "--height MM|MOVEMENT". `without` is the end of a sentence
// in the help: what happens without a drawing. `drawing` must outlive the command.
void add_drawing_options(CLI::App& command, DrawingArguments& drawing, std::string const& without);

// Returns nullopt if no drawing is given.
std::optional<batch::DrawingOptions> drawing_options(DrawingArguments const& drawing,
                                                     tools::Methods const& methods);

} // namespace tractus::options
