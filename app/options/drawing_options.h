#pragma once

#include "app/batch/drawing.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace tractus::options {

// Values of the options for the drawing that a command applies to its plant.
struct DrawingArguments {
    std::string log; // File name; empty if there is no drawing.
    std::string rig;
    std::string height;
};

// Adds "--drawing LOG", "--rig FILE" and "--height MM|MOVEMENT". `without` ends a help sentence
// that says what happens without a drawing. `drawing` must outlive the command.
void add_drawing_options(CLI::App& command, DrawingArguments& drawing, std::string const& without);

// Returns nullopt if no drawing was given.
std::optional<batch::DrawingOptions> drawing_options(DrawingArguments const& drawing,
                                                     tools::Methods const& methods);

} // namespace tractus::options
