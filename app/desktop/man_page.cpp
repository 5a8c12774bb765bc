#include "app/desktop/man_page.h"

#include "app/options/examples.h"
#include "app/options/help.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <sstream>
#include <utility>
#include <vector>

namespace tractus::desktop {

namespace {

// Escapes text for troff, which would replace its escape character, dashes and quotes.
std::string escaped(std::string const& text)
{
    std::string result;
    for (char const c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '\'')
            result += "\\(aq";
        else if (c == '.' && (result.empty() || result.back() == '\n'))
            result += "\\&.";
        else
            result += c;
    }
    return result;
}

// Converts prose to troff. An empty line starts a paragraph; indented lines keep their line breaks.
std::string paragraphs(std::string const& text)
{
    std::istringstream lines(text);
    std::string result;
    bool is_literal = false;
    for (std::string line; std::getline(lines, line);) {
        bool const is_indented = !line.empty() && line.front() == ' ';
        if (is_indented != is_literal)
            result += is_indented ? ".PP\n.nf\n" : ".fi\n";
        if (line.empty() || (is_literal && !is_indented))
            result += ".PP\n";
        is_literal = is_indented;
        if (!line.empty())
            result += escaped(line) + "\n";
    }
    // Removes empty paragraphs, which appear as two successive .PP macros.
    for (std::string const twice = ".PP\n.PP\n"; result.find(twice) != std::string::npos;)
        result.replace(result.find(twice), twice.size(), ".PP\n");
    return result + (is_literal ? ".fi\n" : "");
}

std::string full_name(CLI::App const& command)
{
    return command.get_parent() ? full_name(*command.get_parent()) + " " + command.get_name()
                                : command.get_name();
}

std::vector<CLI::App const*> commands_below(CLI::App const& command)
{
    return command.get_subcommands(
        [](CLI::App const* below) { return !below->get_group().empty(); });
}

std::vector<CLI::Option const*> positionals_of(CLI::App const& command)
{
    return command.get_options([](CLI::Option const* option) { return option->get_positional(); });
}

std::string synopsis(CLI::App const& command)
{
    auto text = fmt::format(".B {}\n[\\fIOPTIONS\\fR...]", escaped(full_name(command)));
    for (auto const* option : positionals_of(command)) {
        auto const name = fmt::format("\\fI{}\\fR", escaped(option->get_name(true)));
        auto const many = option->get_items_expected_max() > 1 ? "..." : "";
        text += option->get_required() ? fmt::format(" {}{}", name, many)
                                       : fmt::format(" [{}]{}", name, many);
    }
    if (!commands_below(command).empty())
        text += " \\fICOMMAND\\fR";
    return text + "\n";
}

std::string option_entry(CLI::Option const& option)
{
    std::string names;
    for (auto const& name : option.get_snames())
        names += fmt::format("{}\\fB\\-{}\\fR", names.empty() ? "" : ", ", escaped(name));
    for (auto const& name : option.get_lnames())
        names += fmt::format("{}\\fB\\-\\-{}\\fR", names.empty() ? "" : ", ", escaped(name));
    if (option.get_items_expected_max() > 0)
        names += fmt::format(" \\fI{}\\fR", escaped(options::shown_type(option)));
    return fmt::format(".TP\n{}\n{}\n", names, escaped(options::option_help(option)));
}

// Lists arguments and options below a heading. `heading` is the macro for it, ".SH" or ".SS".
std::string entries(CLI::App const& command, char const* heading)
{
    std::string text;
    auto const positionals = positionals_of(command);
    if (!positionals.empty())
        text += fmt::format("{} ARGUMENTS\n", heading);
    for (auto const* option : positionals)
        text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", escaped(option->get_name(true)),
                            escaped(options::option_help(*option)));
    text += fmt::format("{} OPTIONS\n", heading);
    for (auto const* option : command.get_options({}))
        if (option->nonpositional())
            text += option_entry(*option);
    return text;
}

// Lists examples of a command and its subcommands.
std::string example_section(CLI::App const& command)
{
    auto lines = options::examples_of(command);
    for (auto const* each : commands_below(command))
        for (auto& line : options::examples_of(*each))
            lines.push_back(std::move(line));
    if (lines.empty())
        return {};
    std::string text = ".SH EXAMPLES\n.nf\n";
    for (auto const& line : lines)
        text += escaped(line) + "\n";
    return text + ".fi\n";
}

std::string upper_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string head(CLI::App const& command, std::string const& what)
{
    auto const name = man_page_name(command);
    return fmt::format(".TH {} 1 \"\" \"tractus " TRACTUS_VERSION "\" \"tractus's manual\"\n"
                       ".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
                       escaped(upper_case(name)), escaped(name), escaped(what));
}

} // namespace

std::string man_page_name(CLI::App const& command)
{
    auto name = full_name(command);
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string program_man_page(CLI::App const& root)
{
    auto const description = root.get_description();
    auto text = head(root, description.substr(description.find(": ") + 2));
    text += synopsis(root) + ".SH DESCRIPTION\n" + paragraphs(root.get_footer());
    text += ".SH COMMANDS\n";
    for (auto const* command : commands_below(root))
        text += fmt::format(".TP\n.BR {} (1)\n{}\n", escaped(man_page_name(*command)),
                            escaped(command->get_description()));
    return text + entries(root, ".SH");
}

std::string command_man_page(CLI::App const& command)
{
    auto text = head(command, command.get_description());
    auto const below = commands_below(command);
    if (below.empty())
        text += synopsis(command);
    for (auto const* each : below)
        text += (each == below.front() ? "" : ".br\n") + synopsis(*each);
    text += ".SH DESCRIPTION\n" + escaped(command.get_description()) + ".\n";
    if (!options::footer_of(command).empty())
        text += ".PP\n" + paragraphs(options::footer_of(command));
    if (below.empty())
        text += entries(command, ".SH");
    for (auto const* each : below) {
        text += fmt::format(".SH {}\n{}.\n", upper_case(escaped(full_name(*each))),
                            escaped(each->get_description()));
        if (!options::footer_of(*each).empty())
            text += ".PP\n" + paragraphs(options::footer_of(*each));
        text += entries(*each, ".SS");
    }
    return text + example_section(command) + ".SH SEE ALSO\n.BR tractus (1)\n";
}

} // namespace tractus::desktop
