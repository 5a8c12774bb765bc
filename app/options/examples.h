#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::options {

// An example of a command line, shown at the end of a command's help and of its manual page.
struct Example {
    char const* command; // Name of the command, such as "session info".
    char const* line;    // Command line without the leading "tractus".
    // True if the example runs unattended in an empty folder, after the earlier examples of
    // examples(). False if it needs a display, hardware, a person, or a file of the user's own.
    bool runs = true;
};

// Examples of all commands except those that methods add. Some use files that earlier examples
// write.
std::span<Example const> examples();

// Returns the example lines of a command, each beginning with "tractus"; empty if it has none.
std::vector<std::string> examples_of(CLI::App const& command);

} // namespace tractus::options
