#pragma once

#include <optional>
#include <string_view>

namespace tractus::svg {

// Reads the numbers of an SVG attribute one after another. Numbers are separated by spaces and
// commas. No separator is needed before a sign or before a number's second decimal point.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text)
        : rest_(text)
    {
    }

    // Returns the next finite number. No value if something else follows, or the end of the text.
    std::optional<double> number();

    // Returns the next digit 0 or 1 as a flag, which needs no separator after it.
    std::optional<bool> flag();

    // Returns the next letter or bracket; no value at the end.
    std::optional<char> symbol();

    // Returns the remaining text without spaces and commas at its beginning.
    std::string_view rest();

private:
    std::string_view rest_;
};

} // namespace tractus::svg
