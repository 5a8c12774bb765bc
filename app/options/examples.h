#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::options {

// An example command line for the end of a command's help and its manual page.
struct Example {
    char const* command; // Name of the command, such as "session info".
    char const* line;    // Command line without the leading "tractus".
    // True if the command runs unattended in an empty folder, after the examples before it in the
    // table. False if it needs a display, hardware, a person, or a file of the user's own.
    bool runs = true;
};

// Examples of all commands except those of the methods. Later ones use files that earlier ones
// write.
std::span<Example const> examples();

// The example lines of one command, each beginning with "tractus"; empty if it has none.
std::vector<std::string> examples_of(CLI::App const& command);

} // namespace tractus::options
