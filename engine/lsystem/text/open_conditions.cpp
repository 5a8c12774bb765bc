#include "engine/lsystem/text/open_conditions.h"

#include "engine/lsystem/text/condition.h"
#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::lsystem {

std::optional<SourcePlace> OpenConditions::open_in_file() const
{
    if (open_.size() == first_in_file_)
        return std::nullopt;
    return open_.back().place;
}

Result<bool> OpenConditions::execute_directive(PlacedText const& line, std::string_view word,
                                               std::string_view rest)
{
    if (word == "elif" || word == "elifdef" || word == "elifndef" || word == "else"
        || word == "endif") {
        TRY(next_part(line, word, rest));
        return true;
    }
    if (word != "if" && word != "ifdef" && word != "ifndef")
        return false;
    Condition opened;
    opened.is_possible = are_on();
    opened.place = line.places[line.characters.find('#')];
    if (opened.is_possible)
        opened.is_on = word == "if" ? TRY(value(line, rest))
                                    : TRY(is_defined(line, rest, word)) == (word == "ifdef");
    opened.was_on = opened.is_on;
    open_.push_back(opened);
    return true;
}

Result<bool> OpenConditions::is_defined(PlacedText const& line, std::string_view rest,
                                        std::string_view word) const
{
    auto const name = first_name(rest);
    if (name.empty() || !is_name_start(name.front()))
        return error(line, 0, fmt::format("found #{} {}, expected a name", word, shown(rest)));
    return macros_.is_defined(name);
}

Result<void> OpenConditions::next_part(PlacedText const& line, std::string_view word,
                                       std::string_view rest)
{
    if (open_.size() == first_in_file_) // A condition of the including file cannot end here.
        return error(line, 0, fmt::format("found #{} without #if", word));
    auto& open = open_.back();
    if (word == "endif") {
        open_.pop_back();
        return {};
    }
    if (open.has_else)
        return error(
            line, 0,
            fmt::format("found #{} behind the #else of the #if at line {}", word, open.place.line));
    bool const is_open = open.is_possible && !open.was_on;
    open.has_else = word == "else";
    open.is_on = is_open
        && (open.has_else
            || (word == "elif" ? TRY(value(line, rest))
                               : TRY(is_defined(line, rest, word)) == (word == "elifdef")));
    open.was_on = open.was_on || open.is_on;
    return {};
}

// Replaces each `defined` in the expression of an #if by 0 or 1. This must precede macro
// replacement.
Result<PlacedText> OpenConditions::without_defined(PlacedText const& text) const
{
    PlacedText ready;
    std::string_view const characters = text.characters;
    auto const skip_blanks = [&](std::size_t from) {
        return std::min(characters.find_first_not_of(" \t\r\n", from), characters.size());
    };
    for (std::size_t i = 0; i < characters.size();) {
        auto const begin = i;
        // Character constants are skipped, so that macros are not replaced inside them.
        if (characters[begin] == '\'')
            if (auto const constant = character_constant(characters, begin)) {
                i = constant->end;
                for (char const digit : fmt::format("({})", constant->value))
                    ready.push(digit, text.places[begin]);
                continue;
            }
        i = token_end(characters, i);
        if (characters.substr(begin, i - begin) != "defined") {
            ready.append(text, begin, i);
            continue;
        }
        auto name_at = skip_blanks(i);
        bool const is_enclosed = characters.substr(name_at, 1) == "(";
        if (is_enclosed)
            name_at = skip_blanks(name_at + 1);
        auto const name = first_name(characters.substr(name_at));
        i = name_at + name.size();
        if (is_enclosed)
            i = skip_blanks(i);
        if (name.empty() || !is_name_start(name.front())
            || (is_enclosed && characters.substr(i, 1) != ")"))
            return error(text, begin, "found 'defined', expected a name or (NAME) behind it");
        i += is_enclosed;
        ready.push(macros_.is_defined(name) ? '1' : '0', text.places[begin]);
    }
    return ready;
}

Result<bool> OpenConditions::value(PlacedText const& line, std::string_view rest)
{
    auto const ready = TRY(without_defined(part_of(line, rest)));
    PlacedText expanded;
    TRY(macros_.expand(ready, expanded));
    auto const end_place = line.places.back();
    expanded.push(' ', end_place);
    auto const result = TRY(condition_value(expanded.characters, [&](auto index, auto const& what) {
        return error(expanded, std::min(index, expanded.size() - 1), what);
    }));
    return result != 0;
}

} // namespace tractus::lsystem
