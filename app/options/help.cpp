#include "app/options/help.h"

#include "app/options/examples.h"

#include <fmt/core.h>
#include <set>
#include <sstream>
#include <string_view>

namespace tractus::options {

static constexpr std::size_t kIndent = 24;
static constexpr std::size_t kLineWidth = 80;
static constexpr std::size_t kTextWidth = kLineWidth - kIndent;

static std::string wrapped(std::string const& text, std::size_t width = kTextWidth)
{
    std::istringstream words(text);
    std::string lines;
    std::size_t column = 0;
    for (std::string word; words >> word; column += word.size()) {
        if (column > 0 && column + 1 + word.size() > width) {
            lines += '\n';
            column = 0;
        } else if (column > 0) {
            lines += ' ';
            ++column;
        }
        lines += word;
    }
    return lines;
}

// Wraps the paragraphs that have lines much too long for a terminal. Indented lines and empty ones
// stay as they are and separate paragraphs.
static std::string with_wrapped_paragraphs(std::string const& text)
{
    constexpr std::size_t kTooLong = kLineWidth + 5;
    std::istringstream lines(text);
    std::string all;
    std::string paragraph;
    bool is_too_long = false;
    auto const end_paragraph = [&] {
        if (!paragraph.empty())
            all += is_too_long ? wrapped(paragraph, kLineWidth) + '\n' : paragraph;
        paragraph.clear();
        is_too_long = false;
    };
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == ' ') {
            end_paragraph();
            all += line + '\n';
            continue;
        }
        paragraph += line + '\n';
        is_too_long |= line.size() > kTooLong;
    }
    end_paragraph();
    return all;
}

static std::string names_of(std::set<CLI::Option*> const& options)
{
    std::string names;
    for (auto const* option : options)
        names += (names.empty() ? "" : ", ") + option->get_name();
    return names;
}

HelpFormatter::HelpFormatter()
{
    column_width(kIndent);
    label("Positionals", "Arguments");
    label("OPTIONS", "OPTIONS...");
    label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_option_opts(CLI::Option const* option) const
{
    if (option->get_positional())
        return {};
    auto const type = shown_type(*option);
    return type.empty() ? type : " " + type;
}

std::string shown_type(CLI::Option const& option)
{
    auto const type = option.get_type_name();
    for (std::string_view const own : { "INT:", "UINT:", "FLOAT:", "TEXT:", "FILE:" })
        if (type.starts_with(own))
            return type.substr(own.size());
    return type;
}

std::string option_help(CLI::Option const& option)
{
    auto text = option.get_description();
    auto const add = [&](std::string const& note) { text += fmt::format(" ({})", note); };
    if (!option.get_default_str().empty())
        add("default: " + option.get_default_str());
    if (option.get_required() && !option.get_positional())
        add("required");
    if (!option.get_needs().empty())
        add("only with " + names_of(option.get_needs()));
    if (!option.get_excludes().empty())
        add("not with " + names_of(option.get_excludes()));
    return text;
}

std::string HelpFormatter::make_option_desc(CLI::Option const* option) const
{
    return wrapped(option_help(*option));
}

std::string HelpFormatter::make_subcommand(CLI::App const* command) const
{
    auto names = command->get_name();
    for (auto const& alias : command->get_aliases())
        names += ", " + alias;
    std::stringstream out;
    CLI::detail::format_help(out, names, wrapped(command->get_description()), get_column_width());
    return out.str();
}

std::string HelpFormatter::make_footer(CLI::App const* command) const
{
    auto text = with_wrapped_paragraphs(footer_of(*command));
    auto const lines = examples_of(*command);
    if (!lines.empty())
        text += text.empty() ? "Examples:\n" : "\nExamples:\n";
    for (auto const& line : lines)
        text += "  " + line + "\n";
    return text;
}

} // namespace tractus::options
