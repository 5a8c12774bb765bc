#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace tractus {

// Helpers for readers of tables: splitting text into lines and lines into columns.

// Removes the first line from the text and returns it without its end-of-line characters.
inline std::string_view take_text_line(std::string_view& text)
{
    auto const end = std::min(text.find('\n'), text.size());
    auto line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r')
        line.remove_suffix(1);
    return line;
}

inline std::string_view without_blanks(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\"";
    auto const begin = std::min(text.find_first_not_of(kBlanks), text.size());
    text.remove_prefix(begin);
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

// Splits a line at every separator; surrounding blanks and quotes are removed from each column.
inline std::vector<std::string_view> columns_of(std::string_view line, char separator)
{
    std::vector<std::string_view> columns;
    for (std::size_t begin = 0; begin <= line.size();) {
        auto const end = std::min(line.find(separator, begin), line.size());
        columns.push_back(without_blanks(line.substr(begin, end - begin)));
        begin = end + 1;
    }
    return columns;
}

// Splits a line at runs of blanks.
inline std::vector<std::string_view> words_of(std::string_view line)
{
    constexpr std::string_view kBlanks = " \t";
    std::vector<std::string_view> words;
    for (auto begin = line.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
        auto const end = std::min(line.find_first_of(kBlanks, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kBlanks, end);
    }
    return words;
}

// Returns the number that a word contains; no value if it is not a number, or is out of range.
inline std::optional<double> number_in(std::string_view word)
{
    double value = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc {} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

} // namespace tractus
