#pragma once

#include "engine/base/result.h"

#include <string_view>

namespace tractus::terminal {

// Makes it safe to print and to write files, whoever started the program: a standard stream that is
// closed stays one that cannot be used, rather than becoming the next file that is opened; and a
// file that may not grow further is an error, not the end of the program. Once, before all else.
void prepare_console();

// Writes to standard output, at once. Fails, as the user's fault, if it is closed or full.
Result<void> print_out(std::string_view text);

// Writes to standard error, at once. Where that cannot be written, nobody is there to be told.
void print_error(std::string_view text);

} // namespace tractus::terminal
