#include "app/terminal/error_text.h"

#include "app/terminal/console.h"
#include "engine/base/file.h"
#include "engine/base/printable.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fmt/core.h>
#include <optional>
#include <string_view>
#include <unistd.h>

namespace tractus::terminal {

namespace {

constexpr std::size_t kMaxShownBytes = std::size_t { 16 } << 20;
// Maximum length of a shown line, in characters. A longer line is cut to the part around the
// column.
constexpr std::size_t kMaxLine = 160;

constexpr std::string_view kBold = "\033[1m";
constexpr std::string_view kRed = "\033[1;31m";
constexpr std::string_view kYellow = "\033[1;33m";
constexpr std::string_view kGreen = "\033[1;32m";
constexpr std::string_view kReset = "\033[0m";

char const* prefix(Fault fault)
{
    switch (fault) {
    case Fault::User:
        return "error";
    case Fault::Device:
        return "device error";
    case Fault::Station:
        return "station error";
    }
    return "error";
}

// A place FILE:LINE:COLUMN at the beginning of a message.
struct Place {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;
    std::size_t length = 0; // Length of the place's own text in the message.
};

// Parses a number at `at` and the colon after it. Returns 0 if they are not there.
std::size_t take_number(std::string_view text, std::size_t& at)
{
    std::size_t value = 0;
    auto const [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    if (error != std::errc() || end == text.data() + text.size() || *end != ':')
        return 0;
    at = static_cast<std::size_t>(end - text.data()) + 1;
    return value;
}

std::optional<Place> find_place(std::string_view message)
{
    for (auto colon = message.find(':'); colon != std::string_view::npos;
         colon = message.find(':', colon + 1)) {
        Place place;
        auto at = colon + 1;
        place.line = take_number(message, at);
        place.column = place.line > 0 ? take_number(message, at) : 0;
        if (place.column == 0)
            continue;
        place.file = message.substr(0, colon);
        place.length = at - 1;
        return place;
    }
    return std::nullopt;
}

// Returns the line of the file at the place, without its line break. No value if the file or the
// line does not exist.
std::optional<std::string> read_line(Place const& place)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(place.file, ignored))
        return std::nullopt;
    auto const text = read_file(place.file, kMaxShownBytes);
    if (!text)
        return std::nullopt;
    std::string_view rest = *text;
    for (auto line = place.line; line > 1; --line) {
        auto const end = rest.find('\n');
        if (end == std::string_view::npos)
            return std::nullopt;
        rest.remove_prefix(end + 1);
    }
    return std::string(rest.substr(0, rest.find_first_of("\r\n")));
}

// Returns the message with its control characters escaped, as it may quote files from untrusted
// sources.
std::string for_terminal(std::string_view message)
{
    return printable(message, "\n\t");
}

// Returns the line, and below it a caret at the column. Control characters become question marks.
std::string excerpt(std::string line, std::size_t column, bool is_colored)
{
    for (auto& c : line)
        if ((static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f')
            c = '?';
    // Replaces C1 control characters, which are encoded in UTF-8.
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        if (line[i] == '\xc2' && static_cast<unsigned char>(line[i + 1]) < 0xa0)
            line[i] = line[i + 1] = '?';
    std::size_t const begin = column > kMaxLine / 2 ? column - kMaxLine / 2 : 0;
    if (begin > 0 || line.size() > kMaxLine)
        line = line.substr(std::min(begin, line.size()), kMaxLine);
    std::string caret;
    for (std::size_t i = 0; i + 1 + begin < column; ++i)
        caret += i < line.size() && line[i] == '\t' ? '\t' : ' ';
    return is_colored ? fmt::format("  {}\n  {}{}^{}\n", line, caret, kGreen, kReset)
                      : fmt::format("  {}\n  {}^\n", line, caret);
}

std::string message_text(std::string_view kind, std::string_view color, std::string_view message,
                         ErrorStyle style)
{
    auto const plain = fmt::format("{}: {}\n", kind, for_terminal(message));
    if (style == ErrorStyle::Plain)
        return plain;
    bool const is_colored = style == ErrorStyle::Colored;
    auto const place = find_place(message);
    auto const line = place ? read_line(*place) : std::nullopt;
    auto const lines = line ? excerpt(*line, place->column, is_colored) : std::string();
    if (!is_colored)
        return plain + lines;
    auto const bold = line ? place->length : 0;
    return fmt::format("{}{}:{} {}{}{}{}\n{}", color, kind, kReset, bold > 0 ? kBold : "",
                       for_terminal(message.substr(0, bold)), bold > 0 ? kReset : "",
                       for_terminal(message.substr(bold)), lines);
}

} // namespace

ErrorStyle error_style()
{
    if (::isatty(STDERR_FILENO) == 0)
        return ErrorStyle::Plain;
    // NOLINTBEGIN(concurrency-mt-unsafe): nobody changes the environment.
    char const* const no_color = std::getenv("NO_COLOR");
    char const* const terminal = std::getenv("TERM");
    // NOLINTEND(concurrency-mt-unsafe)
    bool const is_dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
    // The convention of NO_COLOR is described at no-color.org.
    bool const refuses = no_color != nullptr && *no_color != '\0';
    return is_dumb || refuses ? ErrorStyle::Excerpt : ErrorStyle::Colored;
}

std::string error_text(Error const& error, ErrorStyle style)
{
    return message_text(prefix(error.fault), kRed, error.message, style);
}

std::string warning_text(std::string_view message, ErrorStyle style)
{
    return message_text("warning", kYellow, message, style);
}

void print_warning(std::string_view message)
{
    print_error(warning_text(message, error_style()));
}

} // namespace tractus::terminal
