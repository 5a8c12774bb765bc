#include "engine/lsystem/notations/book_names.h"

#include "engine/lsystem/text/placed_text.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace tractus::lsystem {

namespace {

bool is_name_character(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Returns the strict predecessor, without the contexts around it.
std::string_view strict_part(std::string_view predecessor)
{
    if (auto const left = predecessor.find('<'); left != predecessor.npos)
        predecessor.remove_prefix(left + 1);
    return trimmed_line(predecessor.substr(0, predecessor.find('>')));
}

} // namespace

void BookNames::add_predecessor(std::string_view predecessor)
{
    auto const strict = strict_part(predecessor);
    auto const end = static_cast<std::size_t>(
        std::find_if_not(strict.begin(), strict.end(), is_name_character) - strict.begin());
    auto const rest = trimmed_line(strict.substr(end));
    bool const is_name = end > 1 && std::isalpha(static_cast<unsigned char>(strict.front()))
        && (rest.empty() || rest.front() == '(');
    if (!is_name)
        return;
    auto const commas = static_cast<std::size_t>(std::count(rest.begin(), rest.end(), ','));
    names_[std::string(strict.substr(0, end))].parameter_count = rest.empty() ? 0 : commas + 1;
}

void BookNames::choose_letters(std::string_view text)
{
    static constexpr std::string_view kLetters = "LRABCDEHIJKMNOPQSTUVWXYZabcdehijklmnopqrstuvwxyz";
    auto next = kLetters.begin();
    for (auto& [letters, name] : names_) {
        while (next != kLetters.end() && text.find(*next) != text.npos)
            ++next;
        if (next == kLetters.end())
            return;
        name.letter = *next++;
    }
}

std::string BookNames::in_modules(std::string_view modules) const
{
    std::string result;
    int depth = 0;
    while (!modules.empty()) {
        auto const here = std::find_if(names_.begin(), names_.end(), [&](auto const& entry) {
            return depth == 0 && entry.second.letter != 0 && modules.starts_with(entry.first);
        });
        depth += modules.front() == '(';
        depth -= modules.front() == ')' && depth > 0;
        result += here == names_.end() ? modules.front() : here->second.letter;
        modules.remove_prefix(here == names_.end() ? 1 : here->first.size());
    }
    return result;
}

std::string BookNames::homomorphism_rules() const
{
    std::string rules;
    for (auto const& [letters, name] : names_) {
        if (name.letter == 0 || std::string_view("FfGg").find(letters.front()) == std::string::npos)
            continue;
        std::string parameters;
        for (std::size_t i = 0; i < name.parameter_count; ++i)
            parameters += fmt::format("{}x{}", i == 0 ? "(" : ",", i);
        parameters += parameters.empty() ? "" : ")";
        rules += fmt::format("{0}{1} --> {2}{1}\n", name.letter, parameters, letters.front());
    }
    return rules;
}

} // namespace tractus::lsystem
