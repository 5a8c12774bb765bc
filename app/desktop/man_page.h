#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tractus {

// The manual page of the whole program, which names its verbs, as groff's man macros have it.
std::string program_man_page(CLI::App const& root);

// The manual page of one of its verbs and of what stands below that: all that --help says.
std::string verb_man_page(CLI::App const& verb);

// "tractus-vary" for the verb vary of tractus; the program's own name for the program.
std::string man_page_name(CLI::App const& verb);

} // namespace tractus
