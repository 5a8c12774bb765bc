#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tractus::desktop {

// Returns the program's manual page in groff's man macros. It lists the program's commands.
std::string program_man_page(CLI::App const& root);

// Returns the manual page of a command and its subcommands, with everything that --help shows.
std::string command_man_page(CLI::App const& command);

// Returns the name of a command's manual page: "tractus-vary" for the command "vary", or the
// program's name for the root.
std::string man_page_name(CLI::App const& command);

} // namespace tractus::desktop
