#pragma once

#include "app/render/picture_size.h"

#include <CLI/CLI.hpp>
#include <string>

namespace tractus::options {

// Adds "--size WxH" to a command that writes pictures; one number means a square. `size` holds the
// default. `what` is the option's explanation; `hint` is added to the message about a wrong value.
// `size` must outlive the command.
CLI::Option* add_picture_size_option(CLI::App& command, render::PictureSize& size,
                                     std::string const& what
                                     = "Width and height of a picture in pixels, 16 to 8192 each; "
                                       "one number for both",
                                     std::string const& hint = {});

} // namespace tractus::options
