#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A format string of printf. It is parsed when the model is compiled, so that printing cannot fail.
struct PrintFormat {
    struct Piece {
        std::string text; // Literal text, which is printed before the number.
        // Conversion of the number, such as "%8.3g"; empty: no number is printed.
        std::string conversion;
    };
    std::vector<Piece> pieces;

    std::size_t value_count() const;
};

// Parses the text between the quotes: \n, \t and \r are control characters, %% is a percent sign,
// %d %i %u %x %X %o print the integer part of a number, %f %e %g (and %F %E %G) the number. Widths
// and precisions are limited to 99. Fails with a user error, whose message does not include the
// position.
Result<PrintFormat> parse_print_format(std::string_view text);

// Prints values by the format. Values that are missing count as 0.
std::string print(PrintFormat const& format, std::span<double const> values);

} // namespace tractus::lsystem
