#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::terminal {

// Style of errors and warnings.
enum class ErrorStyle {
    Plain,   // Only the message, in one line, for logs and other programs.
    Excerpt, // The message, the line of the file with the error, and a caret below the column.
    Colored, // Like Excerpt, with colours.
};

// Returns the style that suits standard error: Plain if it is not a terminal; Excerpt, without
// colours, if NO_COLOR is set or the terminal is dumb; otherwise Colored.
ErrorStyle error_style();

// Formats an error, including the line end. An excerpt of the file is shown if the message begins
// with "FILE:LINE:COLUMN: " and the file can be read.
std::string error_text(Error const& error, ErrorStyle style);

// Formats a warning, which is a message about a problem that does not end the program.
std::string warning_text(std::string_view message, ErrorStyle style);

// Prints a warning on standard error, in the style of error_style().
void print_warning(std::string_view message);

} // namespace tractus::terminal
