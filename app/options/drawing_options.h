#pragma once

#include "app/batch/drawing.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace tractus::options {

// Options for what was drawn over a command's plant.
struct DrawingArguments {
    std::string log; // Empty: nothing.
    std::string rig;
    std::string height;
};

// "--drawing LOG", "--rig FILE" and "--height MM|MOVEMENT". `without` ends a sentence: what there
// is without a drawing. `drawing` must live as long as the command.
void add_drawing_options(CLI::App& command, DrawingArguments& drawing, std::string const& without);

// No value where nothing was drawn.
std::optional<batch::DrawingOptions> drawing_options(DrawingArguments const& drawing,
                                                     tools::Methods const& methods);

} // namespace tractus::options
