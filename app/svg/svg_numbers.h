#pragma once

#include <optional>
#include <string_view>

namespace tractus::svg {

// Reads the numbers in an SVG attribute one after another. Numbers are separated by spaces and
// commas, or by nothing if a sign or a second decimal point begins the next one.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text)
        : rest_(text)
    {
    }

    // The next finite number, or no value if something else or the end follows.
    std::optional<double> number();

    // The next 0 or 1, which needs no separator after it.
    std::optional<bool> flag();

    // The next letter or bracket, or no value at the end.
    std::optional<char> symbol();

    // The remaining text without leading spaces and commas.
    std::string_view rest();

private:
    std::string_view rest_;
};

} // namespace tractus::svg
