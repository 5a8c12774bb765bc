#include "app/desktop/man_page.h"

#include "app/help.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <sstream>
#include <vector>

namespace tractus {

namespace {

// Text as troff prints it: its escape character and what would become another dash or quote.
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

// Lines of prose run together; an empty line begins a paragraph, and indented lines stay as they
// are.
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
    // A paragraph that nothing follows is none.
    for (std::string const twice = ".PP\n.PP\n"; result.find(twice) != std::string::npos;)
        result.replace(result.find(twice), twice.size(), ".PP\n");
    return result + (is_literal ? ".fi\n" : "");
}

std::string full_name(CLI::App const& verb)
{
    return verb.get_parent() ? full_name(*verb.get_parent()) + " " + verb.get_name()
                             : verb.get_name();
}

std::vector<CLI::App const*> verbs_below(CLI::App const& verb)
{
    return verb.get_subcommands([](CLI::App const* below) { return !below->get_group().empty(); });
}

std::vector<CLI::Option const*> positionals_of(CLI::App const& verb)
{
    return verb.get_options([](CLI::Option const* option) { return option->get_positional(); });
}

std::string synopsis(CLI::App const& verb)
{
    auto text = fmt::format(".B {}\n[\\fIOPTIONS\\fR...]", escaped(full_name(verb)));
    for (auto const* option : positionals_of(verb)) {
        auto const name = fmt::format("\\fI{}\\fR", escaped(option->get_name(true)));
        auto const many = option->get_items_expected_max() > 1 ? "..." : "";
        text += option->get_required() ? fmt::format(" {}{}", name, many)
                                       : fmt::format(" [{}]{}", name, many);
    }
    if (!verbs_below(verb).empty())
        text += " \\fIVERB\\fR";
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
        names += fmt::format(" \\fI{}\\fR", escaped(option.get_type_name()));
    return fmt::format(".TP\n{}\n{}\n", names, escaped(option_text(option)));
}

// Arguments and options below a heading of the given kind, ".SH" or ".SS".
std::string entries(CLI::App const& verb, char const* heading)
{
    std::string text;
    auto const positionals = positionals_of(verb);
    if (!positionals.empty())
        text += fmt::format("{} ARGUMENTS\n", heading);
    for (auto const* option : positionals)
        text += fmt::format(".TP\n\\fI{}\\fR\n{}\n", escaped(option->get_name(true)),
                            escaped(option_text(*option)));
    text += fmt::format("{} OPTIONS\n", heading);
    for (auto const* option : verb.get_options({}))
        if (option->nonpositional())
            text += option_entry(*option);
    return text;
}

std::string upper_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string head(CLI::App const& verb, std::string const& what)
{
    auto const name = man_page_name(verb);
    return fmt::format(".TH {} 1 \"\" \"tractus " TRACTUS_VERSION "\" \"tractus's manual\"\n"
                       ".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n",
                       escaped(upper_case(name)), escaped(name), escaped(what));
}

} // namespace

std::string man_page_name(CLI::App const& verb)
{
    auto name = full_name(verb);
    std::replace(name.begin(), name.end(), ' ', '-');
    return name;
}

std::string program_man_page(CLI::App const& root)
{
    auto const description = root.get_description();
    auto text = head(root, description.substr(description.find(": ") + 2));
    text += synopsis(root) + ".SH DESCRIPTION\n" + paragraphs(root.get_footer());
    text += ".SH VERBS\n";
    for (auto const* verb : verbs_below(root))
        text += fmt::format(".TP\n.BR {} (1)\n{}\n", escaped(man_page_name(*verb)),
                            escaped(verb->get_description()));
    return text + entries(root, ".SH");
}

std::string verb_man_page(CLI::App const& verb)
{
    auto text = head(verb, verb.get_description());
    auto const below = verbs_below(verb);
    if (below.empty())
        text += synopsis(verb);
    for (auto const* each : below)
        text += (each == below.front() ? "" : ".br\n") + synopsis(*each);
    text += ".SH DESCRIPTION\n" + escaped(verb.get_description()) + ".\n";
    if (!verb.get_footer().empty())
        text += ".PP\n" + paragraphs(verb.get_footer());
    if (below.empty())
        text += entries(verb, ".SH");
    for (auto const* each : below) {
        text += fmt::format(".SH {}\n{}.\n", upper_case(escaped(full_name(*each))),
                            escaped(each->get_description()));
        if (!each->get_footer().empty())
            text += ".PP\n" + paragraphs(each->get_footer());
        text += entries(*each, ".SS");
    }
    return text + ".SH SEE ALSO\n.BR tractus (1)\n";
}

} // namespace tractus
