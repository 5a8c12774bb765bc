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

// Examples of all commands except those that methods add, two or three of each. Some use files that
// earlier examples write.
std::span<Example const> examples();

// Adds examples to a command that a method brings; call it after the command's footer is set and
// its own commands are added, as commands inherit footers. The lines lack the leading "tractus".
// They run unattended after those of examples(), once the input files that they name are there.
void add_examples(CLI::App& command, std::vector<std::string> const& lines);

// Returns the text below a command's options, without its examples.
std::string footer_of(CLI::App const& command);

// Returns the example lines of a command, each beginning with "tractus"; empty if it has none.
std::vector<std::string> examples_of(CLI::App const& command);

} // namespace tractus::options
