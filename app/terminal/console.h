#pragma once

#include "engine/base/result.h"

#include <string_view>

namespace tractus::terminal {

// Makes it safe to print and to write files, however the program was started. A closed standard
// stream stays unusable, rather than becoming the next opened file, and exceeding a file size limit
// is an error instead of a fatal signal. Call it once, first of all.
void prepare_console();

// Writes to standard output without buffering. Fails with a user error if it is closed or full.
Result<void> print_out(std::string_view text);

// Writes to standard error without buffering. Errors are ignored, as there is nowhere to report
// them.
void print_error(std::string_view text);

} // namespace tractus::terminal
