#pragma once

#include "engine/base/result.h"

#include <string_view>

namespace tractus::terminal {

// Makes it safe to print and to write files, however the program was started. A standard stream
// that is closed stays unusable; otherwise the next opened file would take its place. Exceeding a
// limit on file sizes becomes an error instead of a fatal signal. Call this first of all, once.
void prepare_console();

// Writes to standard output without buffering. Fails with a user error if the stream is closed or
// its disk is full.
Result<void> print_out(std::string_view text);

// Writes to standard error without buffering. Errors are ignored, as they cannot be reported
// anywhere.
void print_error(std::string_view text);

} // namespace tractus::terminal
