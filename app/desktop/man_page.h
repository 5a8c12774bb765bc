#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tractus::desktop {

// The manual page of the whole program, which names its commands, as groff's man macros have it.
std::string program_man_page(CLI::App const& root);

// The manual page of one of its commands and of what stands below that: all that --help says.
std::string command_man_page(CLI::App const& command);

// "tractus-vary" for the command vary of tractus; the program's own name for the program.
std::string man_page_name(CLI::App const& command);

} // namespace tractus::desktop
