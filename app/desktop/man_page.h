#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tractus::desktop {

// The program's manual page, which lists its commands, in groff's man macros.
std::string program_man_page(CLI::App const& root);

// The manual page of a command and its subcommands, with everything that --help shows.
std::string command_man_page(CLI::App const& command);

// Name of a command's manual page: "tractus-vary" for the command vary; the program's name for the
// root.
std::string man_page_name(CLI::App const& command);

} // namespace tractus::desktop
