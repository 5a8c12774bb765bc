#include "engine/lsystem/language/print_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fmt/core.h>

namespace tractus::lsystem {

static constexpr std::string_view kIntegers = "diuxXo";
static constexpr std::string_view kNumbers = "fFeEgG";

static char escaped(char c)
{
    switch (c) {
    case 'n':
        return '\n';
    case 't':
        return '\t';
    case 'r':
        return '\r';
    default:
        return c;
    }
}

// Consumes up to `most` characters of `text` from `at` on that occur in `characters`.
static std::string_view take_all(std::string_view text, std::size_t& at,
                                 std::string_view characters, std::size_t most)
{
    auto const begin = at;
    while (at < text.size() && at - begin < most
           && characters.find(text[at]) != std::string_view::npos)
        ++at;
    return text.substr(begin, at - begin);
}

// Reads the conversion whose % is at `at`, and advances `at` past it.
static Result<std::string> take_conversion(std::string_view text, std::size_t& at)
{
    static constexpr std::string_view kDigits = "0123456789";
    auto const begin = at++;
    std::string result = "%";
    result += take_all(text, at, "-+ #0", 5);
    result += take_all(text, at, kDigits, 2);
    if (at < text.size() && text[at] == '.') {
        result += text[at++];
        result += take_all(text, at, kDigits, 2);
    }
    // Length modifiers are ignored: all numbers of a model have the same type.
    take_all(text, at, "lhL", 2);
    char const kind = at < text.size() ? text[at] : '\0';
    if (kind != '\0' && kNumbers.find(kind) != std::string_view::npos)
        result += kind;
    else if (kind != '\0' && kIntegers.find(kind) != std::string_view::npos)
        result += std::string("ll") + (kind == 'u' ? 'd' : kind);
    else
        return fail(Fault::User,
                    fmt::format("found '{}' in a format, expected %d %i %u %x %o %f %e or %g, "
                                "with a width and a precision of at most 99, or %%",
                                text.substr(begin, at + 1 - begin)));
    ++at;
    return result;
}

std::size_t PrintFormat::value_count() const
{
    return static_cast<std::size_t>(
        std::count_if(pieces.begin(), pieces.end(),
                      [](Piece const& piece) { return !piece.conversion.empty(); }));
}

Result<PrintFormat> parse_print_format(std::string_view text)
{
    PrintFormat format;
    PrintFormat::Piece piece;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '\\' && at + 1 < text.size()) {
            piece.text += escaped(text[at + 1]);
            at += 2;
        } else if (text.substr(at, 2) == "%%") {
            piece.text += '%';
            at += 2;
        } else if (text[at] == '%') {
            piece.conversion = TRY(take_conversion(text, at));
            format.pieces.push_back(std::exchange(piece, {}));
        } else {
            piece.text += text[at++];
        }
    }
    if (!piece.text.empty())
        format.pieces.push_back(std::move(piece));
    return format;
}

static std::string print_number(std::string const& conversion, double value)
{
    std::array<char, 512> text {}; // The largest number has 309 digits before the decimal point.
    bool const is_integer = kIntegers.find(conversion.back()) != std::string_view::npos;
    auto const integer
        = std::isnan(value) ? 0LL : static_cast<long long>(std::clamp(value, -9e18, 9e18));
    auto const length = is_integer
        ? std::snprintf(text.data(), text.size(), conversion.c_str(), integer)
        : std::snprintf(text.data(), text.size(), conversion.c_str(), value);
    return { text.data(), static_cast<std::size_t>(std::max(length, 0)) };
}

std::string print(PrintFormat const& format, std::span<double const> values)
{
    std::string result;
    std::size_t next = 0;
    for (auto const& piece : format.pieces) {
        result += piece.text;
        if (!piece.conversion.empty())
            result += print_number(piece.conversion, next < values.size() ? values[next++] : 0);
    }
    return result;
}

} // namespace tractus::lsystem
