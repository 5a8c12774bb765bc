#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::terminal {

// How errors and warnings are shown to whoever reads them.
enum class ErrorStyle {
    Plain,   // One line, for logs and other programs.
    Excerpt, // Shows the line of the file that is wrong, and a caret under the column.
    Colored, // Excerpt in colours.
};

// How standard error wants them: plain unless it is a terminal, and without colours where NO_COLOR
// is set or the terminal is dumb.
ErrorStyle error_style();

// The error, with its line's end. The excerpt is that of a message that begins with
// "FILE:LINE:COLUMN: ", if the file can be read.
std::string error_text(Error const& error, ErrorStyle style);

// Returns the text of what does not end the work.
std::string warning_text(std::string_view message, ErrorStyle style);

// Writes a warning to standard error as it wants them.
void print_warning(std::string_view message);

} // namespace tractus::terminal
