#pragma once

#include <optional>
#include <string_view>

namespace tractus::svg {

// Reads the numbers in an SVG attribute, one after another: they stand apart by spaces and commas,
// or by nothing where a sign or a second point begins the next one.
class SvgNumbers {
public:
    explicit SvgNumbers(std::string_view text)
        : rest_(text)
    {
    }

    // The next number, finite; no value if something else comes, or nothing.
    std::optional<double> number();

    // The next 0 or 1, which needs nothing to stand apart from what follows.
    std::optional<bool> flag();

    // The next letter or bracket; no value at the end.
    std::optional<char> symbol();

    // Returns what is left, without the spaces and commas before it.
    std::string_view rest();

private:
    std::string_view rest_;
};

} // namespace tractus::svg
