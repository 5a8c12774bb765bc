#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::options {

// A line to type, for the end of a command's help and its manual page.
struct Example {
    char const* command; // The command's words: "session info".
    char const* line;    // Without the leading "tractus".
    // Runs by itself in an empty folder, after the examples before it in the table. Others need a
    // display, hardware, a person, or a file of one's own.
    bool runs = true;
};

// Examples of all commands but the methods' own. Later ones use files that earlier ones write.
std::span<Example const> examples();

// The lines for one command, each with "tractus" before it; none for commands without examples.
std::vector<std::string> examples_of(CLI::App const& command);

} // namespace tractus::options
