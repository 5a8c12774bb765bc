#include "engine/lsystem/language/book_habits.h"

#include "engine/lsystem/text/placed_text.h"
#include "engine/lsystem/text/user_text.h"

#include <cctype>
#include <cstddef>
#include <fmt/format.h>

namespace tractus::lsystem {

namespace {

bool is_letter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Skips a module's parameters in parentheses, if `text` begins with them. Returns the text after
// them; empty if the parentheses do not close.
std::string_view behind_parameters(std::string_view text)
{
    if (text.substr(0, 1) != "(")
        return text;
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        depth += text[i] == '(';
        depth -= text[i] == ')';
        if (depth == 0)
            return trimmed_line(text.substr(i + 1));
    }
    return {};
}

} // namespace

std::optional<std::string> label_of_production(std::string_view line, Names const& names)
{
    line = trimmed_line(line);
    auto const end = line.find_first_not_of("0123456789", 1);
    if (line.empty() || !is_letter(line.front()) || end == line.npos || end < 2)
        return std::nullopt;
    auto rest = trimmed_line(line.substr(end));
    if (rest.substr(0, 1) != ":")
        return std::nullopt;
    rest = trimmed_line(rest.substr(1));
    if (rest.empty() || !is_letter(rest.front()) || names.find_variable(rest.substr(0, 1)))
        return std::nullopt;
    auto const behind = behind_parameters(trimmed_line(rest.substr(1)));
    bool const is_module = behind.starts_with("-->") || behind.starts_with("->")
        || behind.starts_with(":") || behind.starts_with("<") || behind.starts_with(">");
    return is_module ? std::optional(std::string(line.substr(0, end))) : std::nullopt;
}

std::string describe_label(std::string_view label)
{
    return fmt::format(
        "{}: is read as a rule for the modules {} and {}, since rules have no labels "
        "here; leave it out (--dialect book leaves out all of them)",
        label, label.front(), label.substr(1));
}

std::string describe_wrong_arrow(std::string_view line)
{
    if (line.find("-->") != line.npos)
        return {};
    for (std::string_view const arrow : { "->", "\u2192", "\u27f6", "\u2013>", "\u2014>", "=>" })
        if (line.find(arrow) != line.npos)
            return fmt::format("found '{}', expected -->: the arrow of rules has two dashes here "
                               "(--dialect book reads both)",
                               shown(trimmed_line(line)));
    return {};
}

bool is_figure_of_book(std::string_view line)
{
    line = trimmed_line(line);
    return line.starts_with("n") && trimmed_line(line.substr(1)).starts_with("=");
}

bool is_axiom_of_book(std::string_view line)
{
    line = trimmed_line(line);
    for (std::string_view const word : { "\u03c9", "omega", "w" })
        if (line.starts_with(word) && trimmed_line(line.substr(word.size())).starts_with(":"))
            return true;
    return false;
}

} // namespace tractus::lsystem
