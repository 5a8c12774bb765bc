#include "engine/lsystem/text/placed_text.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>

namespace tractus::lsystem {

void PlacedText::append(PlacedText const& other, std::size_t begin, std::size_t end)
{
    characters.append(other.characters, begin, end - begin);
    places.insert(places.end(), other.places.begin() + static_cast<std::ptrdiff_t>(begin),
                  other.places.begin() + static_cast<std::ptrdiff_t>(end));
}

PlacedText part_of(PlacedText const& text, std::string_view view)
{
    PlacedText result;
    auto const begin = static_cast<std::size_t>(view.data() - text.characters.data());
    result.append(text, begin, begin + view.size());
    return result;
}

tl::unexpected<Error> error_in(PlacedText const& text, std::size_t index,
                               std::vector<std::string> const& files, std::string const& what)
{
    auto const place = index < text.places.size() ? text.places[index] : SourcePlace {};
    return fail(Fault::User,
                fmt::format("{}:{}:{}: {}", files[place.file], place.line, place.column, what));
}

bool is_name_start(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
static bool is_name_part(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
// Returns true if the sign at index `at` belongs to the number before it, as in 1e-3.
static bool is_exponent_sign(std::string_view text, std::size_t at)
{
    return (text[at] == '+' || text[at] == '-') && (text[at - 1] == 'e' || text[at - 1] == 'E');
}
bool is_digit(char c)
{
    return std::isdigit(static_cast<unsigned char>(c));
}
bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r';
}

// Returns the index after the closing quote of the string literal that begins at index `begin`. No
// value if the literal does not end in its line.
static std::optional<std::size_t> string_end(std::string_view text, std::size_t begin)
{
    for (auto at = begin + 1; at < text.size() && text[at] != '\n'; ++at) {
        if (text[at] == '"')
            return at + 1;
        if (text[at] == '\\' && at + 1 < text.size() && text[at + 1] != '\n')
            ++at;
    }
    return std::nullopt;
}

std::size_t token_end(std::string_view text, std::size_t begin)
{
    auto end = begin + 1;
    if (is_name_start(text[begin])) {
        while (end < text.size() && is_name_part(text[end]))
            ++end;
    } else if (is_digit(text[begin])
               || (text[begin] == '.' && end < text.size() && is_digit(text[end]))) {
        while (end < text.size()
               && (is_name_part(text[end]) || text[end] == '.' || is_exponent_sign(text, end)))
            ++end;
    } else if (text[begin] == '"') {
        end = string_end(text, begin).value_or(std::min(text.find('\n', begin), text.size()));
    }
    return end;
}

// Returns true if only blanks follow in the line from index `at` on. As in gcc, a \ before such
// blanks counts as the last character of its line.
static bool ends_line(std::string_view source, std::size_t at)
{
    while (at < source.size() && is_blank(source[at]))
        ++at;
    return at < source.size() && source[at] == '\n';
}

PlacedText without_comments(std::string_view source, std::uint32_t file,
                            std::optional<SourcePlace>& open_comment)
{
    PlacedText result;
    SourcePlace place { file, 1, 1 };
    std::size_t i = 0;
    // Set after a failed search for a closing quote, so that the rest of the line is not searched
    // again.
    std::size_t no_string_before = 0;
    auto const advance = [&] {
        if (source[i++] == '\n') {
            ++place.line;
            place.column = 1;
        } else {
            ++place.column;
        }
    };
    while (i < source.size()) {
        if (source.substr(i, 2) == "//") {
            while (i < source.size() && source[i] != '\n')
                advance();
        } else if (source.substr(i, 2) == "/*") {
            result.push(' ', place);
            auto const close = source.find("*/", i + 2);
            if (close == std::string_view::npos)
                open_comment = place;
            auto const end = std::min(close, source.size() - 2) + 2;
            while (i < end)
                advance();
        } else if (source[i] == '\\' && ends_line(source, i + 1)) {
            result.push('\\', place);
            while (i < source.size() && source[i] != '\n')
                advance();
        } else {
            auto end = i + 1;
            if (source[i] == '"' && i >= no_string_before) {
                auto const string = string_end(source, i);
                end = string.value_or(end);
                if (!string)
                    no_string_before = std::min(source.find('\n', i), source.size());
            }
            while (i < end) {
                if (source[i] != '\r')
                    result.push(source[i], place);
                advance();
            }
        }
    }
    return result;
}

// Returns true if the text after a // looks like modules rather than a comment in words.
static bool reads_as_modules(std::string_view before, std::string_view behind)
{
    while (!behind.empty() && (is_blank(behind.back()) || behind.back() == '\n'))
        behind.remove_suffix(1);
    if (behind.find_first_of(" \t") != std::string_view::npos)
        return false;
    bool const is_rule_off = behind.find_first_not_of('/') == std::string_view::npos;
    if (is_rule_off) // Slashes directly after a module are meant as rolls.
        return !is_blank(before.back());
    return behind.find_first_of("[]'+-&^/!$|\\(") != std::string_view::npos
        || (!is_blank(before.back()) && std::isupper(static_cast<unsigned char>(behind.front())));
}

std::vector<SourcePlace> productions_cut_by_comments(std::string_view source, std::uint32_t file)
{
    std::vector<SourcePlace> result;
    bool is_in_comment = false;
    std::uint32_t line_number = 0;
    for (std::size_t begin = 0; begin < source.size();) {
        auto const end = std::min(source.find('\n', begin), source.size());
        auto const line = source.substr(begin, end - begin);
        begin = end + 1;
        ++line_number;
        std::size_t at = 0;
        while (at < line.size()) {
            auto const pair = line.substr(at, 2);
            if (pair == (is_in_comment ? "*/" : "/*")) {
                is_in_comment = !is_in_comment;
                at += 2;
            } else if (!is_in_comment && pair == "//") {
                break;
            } else {
                ++at;
            }
        }
        auto const before = line.substr(0, at);
        bool const is_production = before.find("-->") != std::string_view::npos
            || before.find("xiom:") != std::string_view::npos;
        if (at < line.size() && is_production && reads_as_modules(before, line.substr(at + 2)))
            result.push_back({ file, line_number, static_cast<std::uint32_t>(at + 1) });
    }
    return result;
}

std::string_view trimmed_line(std::string_view text)
{
    while (!text.empty() && is_blank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && (is_blank(text.back()) || text.back() == '\n'))
        text.remove_suffix(1);
    return text;
}

std::string_view first_name(std::string_view text)
{
    std::size_t end = 0;
    while (end < text.size() && is_name_part(text[end]))
        ++end;
    return text.substr(0, end);
}

} // namespace tractus::lsystem
