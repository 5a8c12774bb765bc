#include "engine/lsystem/macro_table.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus {

// What a hostile model may make of itself by macros that double at each use.
static constexpr std::size_t kMaxTextSize = std::size_t { 16 } << 20;
static constexpr std::size_t kMaxMacroNesting = 64;

Result<void> MacroTable::define(PlacedText const& line, std::string_view rest)
{
    auto const name = first_name(rest);
    if (name.empty() || !is_name_start(name.front()))
        return error(line, 0, fmt::format("found #define {}, expected a name", rest));
    Macro macro;
    rest.remove_prefix(name.size());
    if (!rest.empty() && rest.front() == '(') {
        auto const close = rest.find(')');
        if (close == std::string_view::npos)
            return error(line, 0, fmt::format("#define {}( has no closing parenthesis", name));
        macro.has_parameters = true;
        auto list = rest.substr(1, close - 1);
        while (!trimmed_line(list).empty()) {
            auto const comma = std::min(list.find(','), list.size());
            macro.parameters.emplace_back(trimmed_line(list.substr(0, comma)));
            list.remove_prefix(std::min(comma + 1, list.size()));
        }
        rest.remove_prefix(close + 1);
    }
    macro.body = trimmed_line(rest);
    for (std::size_t i = 0; i + 1 < macro.body.size(); ++i)
        if (macro.body[i] == '\\' && macro.body[i + 1] == '\n')
            macro.body[i] = macro.body[i + 1] = ' ';
    macros_.insert_or_assign(std::string(name), std::move(macro));
    return {};
}

void MacroTable::undefine(std::string_view name)
{
    macros_.erase(std::string(name));
}

std::string_view MacroTable::body(std::string_view name) const
{
    auto const macro = macros_.find(name);
    return macro == macros_.end() ? name : macro->second.body;
}

Result<void> MacroTable::expand(PlacedText const& text, PlacedText& out) const
{
    Active active;
    return expand(text, out, active);
}

Result<void> MacroTable::expand(PlacedText const& text, PlacedText& out, Active& active) const
{
    if (out.size() > kMaxTextSize)
        return error(text, 0, "macros make more than 16 MB of text here");
    std::string_view const characters = text.characters;
    for (std::size_t i = 0; i < characters.size();) {
        auto const end = token_end(characters, i);
        auto const macro = is_name_start(characters[i])
            ? macros_.find(characters.substr(i, end - i))
            : macros_.end();
        if (macro != macros_.end()
            && std::find(active.begin(), active.end(), macro->first) == active.end()) {
            if (!macro->second.has_parameters) {
                PlacedText body { macro->second.body, {} };
                body.places.assign(body.size(), text.places[i]);
                TRY(expand_body(macro->first, body, out, active));
                i = end;
                continue;
            }
            auto open = end;
            while (open < characters.size() && is_blank(characters[open]))
                ++open;
            if (open < characters.size() && characters[open] == '(') {
                i = TRY(expand_call(macro->second, macro->first, text, open, out, active));
                continue;
            }
        }
        for (; i < end; ++i)
            out.push(characters[i], text.places[i]);
    }
    return {};
}

Result<void> MacroTable::expand_body(std::string const& name, PlacedText const& body,
                                     PlacedText& out, Active& active) const
{
    if (active.size() > kMaxMacroNesting)
        return error(body, 0, fmt::format("macros are nested deeper than {}", kMaxMacroNesting));
    active.push_back(name);
    TRY(expand(body, out, active));
    active.pop_back();
    return {};
}

// Reads the arguments of the call whose parenthesis is at `open`; returns where the other one is.
Result<std::size_t> MacroTable::find_arguments(PlacedText const& text, std::size_t open,
                                               std::string const& name,
                                               std::vector<PlacedText>& arguments) const
{
    int depth = 0;
    arguments.resize(1);
    for (auto i = open; i < text.size(); ++i) {
        char const c = text.characters[i];
        if (c == '(' && ++depth == 1)
            continue;
        if (c == ')' && --depth == 0)
            return i;
        if (c == ',' && depth == 1)
            arguments.emplace_back();
        else
            arguments.back().push(c, text.places[i]);
    }
    return error(text, open, fmt::format("the call of macro {} has no closing parenthesis", name));
}

// Replaces a macro with parameters whose call's parenthesis is at `open`; returns the call's end.
Result<std::size_t> MacroTable::expand_call(Macro const& macro, std::string const& name,
                                            PlacedText const& text, std::size_t open,
                                            PlacedText& out, Active& active) const
{
    std::vector<PlacedText> arguments;
    auto const close = TRY(find_arguments(text, open, name, arguments));
    if (arguments.size() != std::max<std::size_t>(macro.parameters.size(), 1))
        return error(text, open,
                     fmt::format("macro {} has {} parameters, found {} arguments", name,
                                 macro.parameters.size(), arguments.size()));
    PlacedText body;
    for (std::size_t k = 0; k < macro.body.size();) {
        auto const end = token_end(macro.body, k);
        auto const parameter = std::find(macro.parameters.begin(), macro.parameters.end(),
                                         macro.body.substr(k, end - k));
        if (parameter != macro.parameters.end())
            TRY(expand(arguments[static_cast<std::size_t>(parameter - macro.parameters.begin())],
                       body, active));
        else
            for (auto j = k; j < end; ++j)
                body.push(macro.body[j], text.places[open]);
        k = end;
    }
    TRY(expand_body(name, body, out, active));
    return close + 1;
}

} // namespace tractus
