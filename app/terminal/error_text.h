#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::terminal {

// Style of errors and warnings.
enum class ErrorStyle {
    Plain,   // One line of text, for logs and other programs.
    Excerpt, // Also shows the line of the file with the error, and a caret below the column.
    Colored, // Like Excerpt, in colours.
};

// Style suitable for standard error: Plain unless it is a terminal, and without colours if NO_COLOR
// is set or the terminal is dumb.
ErrorStyle error_style();

// Formats an error, including the line end. An excerpt is shown if the message begins with
// "FILE:LINE:COLUMN: " and the file can be read.
std::string error_text(Error const& error, ErrorStyle style);

// Formats a warning, which does not end the program.
std::string warning_text(std::string_view message, ErrorStyle style);

// Writes a warning to standard error in its suitable style.
void print_warning(std::string_view message);

} // namespace tractus::terminal
