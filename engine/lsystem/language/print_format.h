#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

// A format of printf's, taken apart when a model is compiled, so that printing cannot fail.
struct PrintFormat {
    struct Piece {
        std::string text;       // Printed as it is,
        std::string conversion; // then a number in this way, such as "%8.3g"; empty: none.
    };
    std::vector<Piece> pieces;

    std::size_t value_count() const;
};

// Reads what stands between the quotes: \n, \t and \r are characters, %% is a percent sign, %d %i
// %u %x %X %o print the integer part of a number, %f %e %g (and %F %E %G) the number. Widths and
// precisions are at most 99. Fails, as the user's fault, without the place.
Result<PrintFormat> parse_print_format(std::string_view text);

// Values that are missing are 0.
std::string print(PrintFormat const& format, std::span<double const> values);

} // namespace tractus::lsystem
