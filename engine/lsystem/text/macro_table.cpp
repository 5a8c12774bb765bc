#include "engine/lsystem/text/macro_table.h"

#include "engine/lsystem/text/user_text.h"

#include <algorithm>
#include <fmt/core.h>
#include <iterator>
#include <utility>

namespace tractus::lsystem {

// Limits as a protection against hostile models whose macros double in size with each use.
static constexpr std::size_t kMaxTextSize = std::size_t { 16 } << 20;
static constexpr std::size_t kMaxWork = std::size_t { 64 } << 20;
static constexpr std::size_t kTokenCost = 16;
static constexpr std::size_t kMaxTokens = 2'000'000; // Maximum number of tokens in memory.
static constexpr int kMaxCallNesting = 64;

static bool is_blank_token(std::string const& characters)
{
    return characters.size() == 1 && (is_blank(characters[0]) || characters[0] == '\n');
}

// Appends a text with the escapes that it needs in a string literal.
static void append_escaped(std::string& string, std::string_view text)
{
    for (char const c : text) {
        if (c == '"' || c == '\\')
            string += '\\';
        string += c;
    }
}

static std::string quoted_text(std::string_view text)
{
    std::string result = "\"";
    append_escaped(result, text);
    return result + '"';
}

tl::unexpected<Error> MacroTable::error(SourcePlace const& place, std::string const& what) const
{
    return fail(Fault::User,
                fmt::format("{}:{}:{}: {}", files_[place.file], place.line, place.column, what));
}

MacroTable::Tokens MacroTable::tokens_of(PlacedText const& text)
{
    Tokens result;
    for (std::size_t i = 0; i < text.size();) {
        auto const end = token_end(text.characters, i);
        result.push_back({ text.characters.substr(i, end - i), text.places[i], false, false, 0 });
        i = end;
    }
    return result;
}

Result<std::string_view> MacroTable::set_parameters(Macro& macro, PlacedText const& line,
                                                    std::string_view rest)
{
    auto const close = rest.find(')');
    if (close == std::string_view::npos)
        return error(line, 0, "the parameters of this #define have no closing parenthesis");
    macro.has_parameters = true;
    auto list = rest.substr(1, close - 1);
    while (!trimmed_line(list).empty()) {
        auto const comma = std::min(list.find(','), list.size());
        auto const written = trimmed_line(list.substr(0, comma));
        auto parameter = written;
        macro.is_variadic
            = parameter.size() >= 3 && parameter.substr(parameter.size() - 3) == "...";
        if (macro.is_variadic) // As in gcc, the variable arguments may have a name.
            parameter = trimmed_line(parameter.substr(0, parameter.size() - 3));
        if (macro.is_variadic && parameter.empty())
            parameter = "__VA_ARGS__";
        if (parameter.empty() || !is_name_start(parameter.front())
            || first_name(parameter) != parameter)
            return error(line, 0,
                         fmt::format("found '{}' among the parameters of #define, expected a name",
                                     shown(written)));
        macro.parameters.emplace_back(parameter);
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return rest.substr(close + 1);
}

// Sets a macro's replacement list. Blanks around ## are removed, because it joins the tokens on
// both sides.
Result<void> MacroTable::set_body(Macro& macro, PlacedText const& line, std::string_view text)
{
    PlacedText body { std::string(trimmed_line(text)), {} };
    body.places.resize(body.size());
    auto tokens = tokens_of(body);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        auto& token = tokens[i];
        token.is_in_body = true;
        bool const is_paste
            = token.characters == "#" && i + 1 < tokens.size() && tokens[i + 1].characters == "#";
        bool const is_after_paste = !macro.body.empty() && macro.body.back().is_paste;
        if (is_paste) {
            while (!macro.body.empty() && is_blank_token(macro.body.back().characters))
                macro.body.pop_back();
            token.is_paste = true;
            ++i;
        } else if (is_after_paste && is_blank_token(token.characters)) {
            continue;
        }
        macro.body.push_back(std::move(token));
    }
    if (!macro.body.empty() && (macro.body.front().is_paste || macro.body.back().is_paste))
        return error(line, 0,
                     "## joins what is on its two sides and cannot begin or end a #define; for "
                     "the turtle symbol twice, write # #");
    return {};
}

Result<void> MacroTable::define(PlacedText const& line, std::string_view rest)
{
    auto const name = first_name(rest);
    if (name.empty() || !is_name_start(name.front()))
        return error(line, 0, fmt::format("found #define {}, expected a name", shown(rest)));
    if (name == "defined")
        return error(line, 0, "'defined' is a word of #if and cannot be a macro");
    Macro macro;
    macro.number = next_number_++;
    rest.remove_prefix(name.size());
    if (!rest.empty() && rest.front() == '(')
        rest = TRY(set_parameters(macro, line, rest));
    TRY(set_body(macro, line, rest));
    macros_.insert_or_assign(std::string(name), std::move(macro));
    return {};
}

void MacroTable::undefine(std::string_view name)
{
    if (auto const macro = macros_.find(name); macro != macros_.end())
        macros_.erase(macro);
}

MacroTable::Macro const* MacroTable::macro_for(Token const& token) const
{
    if (token.characters.empty() || !is_name_start(token.characters.front()))
        return nullptr;
    auto const macro = macros_.find(token.characters);
    if (macro == macros_.end())
        return nullptr;
    return hidden_.has(token.hidden, macro->second.number) ? nullptr : &macro->second;
}

// Replaces __LINE__ or __FILE__ by its value. Returns true if the token was one of them.
bool MacroTable::expand_place_macro(Token& token) const
{
    if (!is_place_macro(token.characters) || macros_.find(token.characters) != macros_.end())
        return false;
    token.characters = token.characters == "__LINE__" ? std::to_string(token.place.line)
                                                      : quoted_text(files_[token.place.file]);
    token.is_in_body = true;
    return true;
}

// Returns true if the text seems to end inside a macro call. Replaces no macros: an expansion that
// is then discarded would take longer.
bool MacroTable::ends_in_call(PlacedText const& text) const
{
    std::string_view const characters = text.characters;
    int depth = 0; // Depth of parentheses, counted from the beginning of a call.
    bool follows_macro = false;
    for (std::size_t i = 0; i < characters.size();) {
        auto const end = token_end(characters, i);
        auto const token = characters.substr(i, end - i);
        i = end;
        if (is_blank(token.front()) || token == "\n")
            continue;
        if (token == "(" && (depth > 0 || follows_macro))
            ++depth;
        else if (token == ")" && depth > 0)
            --depth;
        follows_macro = false;
        if (depth == 0 && is_name_start(token.front())) {
            auto const macro = macros_.find(token);
            follows_macro = macro != macros_.end() && macro->second.has_parameters;
        }
    }
    return depth > 0 || follows_macro;
}

Result<HiddenMacros::Id> MacroTable::known_set(std::optional<HiddenMacros::Id> set,
                                               SourcePlace const& place) const
{
    if (!set)
        return error(place,
                     fmt::format("macros are nested deeper than {}", HiddenMacros::kMaxNesting));
    return *set;
}

Result<void> MacroTable::spend(std::size_t size, SourcePlace const& place)
{
    spent_ += size + kTokenCost;
    if (spent_ > kMaxWork)
        return error(place, "macros make more than 16 MB of text here");
    return {};
}

Result<bool> MacroTable::expand_whole(PlacedText const& text, PlacedText& out)
{
    if (ends_in_call(text))
        return false;
    auto const size = out.size();
    auto const spent = spent_;
    ended_in_call_ = false;
    auto result = expand(text, out);
    if (!ended_in_call_) {
        TRY(std::move(result));
        return true;
    }
    out.characters.resize(size);
    out.places.resize(size);
    spent_ = spent;
    return false;
}

Result<void> MacroTable::expand(PlacedText const& text, PlacedText& out)
{
    std::string_view const characters = text.characters;
    bool has_macros = false;
    for (std::size_t i = 0; i < characters.size() && !has_macros;) {
        auto const end = token_end(characters, i);
        has_macros = is_name_start(characters[i]) && is_defined(characters.substr(i, end - i));
        i = end;
    }
    if (!has_macros) {
        out.characters += text.characters;
        out.places.insert(out.places.end(), text.places.begin(), text.places.end());
        return {};
    }
    auto rest = tokens_of(text);
    std::reverse(rest.begin(), rest.end());
    std::string last; // The last token, with which the next one must not merge.
    return expand(rest, 0, [&](Token const& token) -> Result<void> {
        if (out.size() > kMaxTextSize)
            return error(token.place, "macros make more than 16 MB of text here");
        if (token.characters.empty())
            return {};
        auto place = token.place;
        if (token_end(last + token.characters.front(), 0) > std::max<std::size_t>(last.size(), 1))
            out.push(' ', place);
        last = token.characters;
        for (char const c : token.characters) {
            out.push(c, place);
            place.column += token.is_in_body ? 0 : 1;
        }
        return {};
    });
}

// Replaces macros by Dave Prosser's algorithm, which the C standard describes in words. `rest` is
// the text in reverse, because a macro's replacement is put in front of it.
template<typename Sink> Result<void> MacroTable::expand(Tokens& rest, int depth, Sink const& sink)
{
    while (!rest.empty()) {
        auto token = std::move(rest.back());
        rest.pop_back();
        auto const* const macro = macro_for(token);
        Call call;
        call.place = token.place;
        call.depth = depth;
        auto hidden = token.hidden;
        if (expand_place_macro(token) || !macro
            || (macro->has_parameters && !TRY(take_call(*macro, token, rest, call, hidden)))) {
            TRY(sink(token));
            continue;
        }
        hidden = TRY(known_set(hidden_.with(hidden, macro->number), token.place));
        auto replacement = TRY(substitute(*macro, call));
        TRY(spend(0, token.place));
        for (auto& part : replacement) {
            TRY(spend(part.characters.size(), token.place));
            part.hidden = TRY(known_set(hidden_.in_any(part.hidden, hidden), token.place));
        }
        if (rest.size() + replacement.size() > kMaxTokens)
            return error(token.place, "macros make more than 16 MB of text here");
        std::move(replacement.rbegin(), replacement.rend(), std::back_inserter(rest));
    }
    return {};
}

// Reads the arguments of a call from `rest`. Returns false if no parenthesis follows the macro's
// name.
Result<bool> MacroTable::take_call(Macro const& macro, Token const& name, Tokens& rest, Call& call,
                                   HiddenMacros::Id& hidden)
{
    auto open = rest.size();
    while (open > 0 && is_blank_token(rest[open - 1].characters))
        --open;
    ended_in_call_ |= open == 0 && call.depth == 0;
    if (open == 0 || rest[open - 1].characters != "(")
        return false;
    auto const open_place = rest[open - 1].place;
    rest.resize(open - 1);
    call.arguments.resize(1);
    for (int depth = 1; !rest.empty();) {
        auto token = std::move(rest.back());
        rest.pop_back();
        depth += (token.characters == "(") - (token.characters == ")");
        if (depth == 0) {
            hidden = TRY(known_set(hidden_.in_both(hidden, token.hidden), name.place));
            TRY(check_arguments(macro, { name.characters, open_place, false, false, 0 }, call));
            return true;
        }
        bool const is_rest = macro.is_variadic && call.arguments.size() == macro.parameters.size();
        if (token.characters == "," && depth == 1 && !is_rest)
            call.arguments.emplace_back();
        else
            call.arguments.back().push_back(std::move(token));
    }
    ended_in_call_ |= call.depth == 0;
    return error(open_place,
                 fmt::format("the call of macro {} has no closing parenthesis", name.characters));
}

Result<void> MacroTable::check_arguments(Macro const& macro, Token const& name, Call& call) const
{
    call.leaves_out_rest
        = macro.is_variadic && call.arguments.size() + 1 == macro.parameters.size();
    if (call.leaves_out_rest)
        call.arguments.emplace_back();
    if (call.arguments.size() != std::max<std::size_t>(macro.parameters.size(), 1))
        return error(name.place,
                     fmt::format("macro {} has {} parameters, found {} arguments", name.characters,
                                 macro.parameters.size(), call.arguments.size()));
    for (auto& argument : call.arguments) {
        while (!argument.empty() && is_blank_token(argument.back().characters))
            argument.pop_back();
        auto const first = std::find_if(argument.begin(), argument.end(), [](Token const& token) {
            return !is_blank_token(token.characters);
        });
        argument.erase(argument.begin(), first);
    }
    call.expanded.resize(call.arguments.size());
    call.is_expanded.resize(call.arguments.size());
    return {};
}

// Returns the index of the macro's parameter that the token names; the number of parameters if it
// names none.
std::size_t MacroTable::parameter_index(Macro const& macro, Token const& token)
{
    return static_cast<std::size_t>(
        std::find(macro.parameters.begin(), macro.parameters.end(), token.characters)
        - macro.parameters.begin());
}

Result<MacroTable::Tokens> MacroTable::substitute(Macro const& macro, Call& call)
{
    Tokens result;
    for (std::size_t i = 0; i < macro.body.size(); ++i) {
        auto const& token = macro.body[i];
        bool const pastes = token.is_paste;
        if (pastes)
            ++i;
        Tokens next;
        if (macro.has_parameters && macro.body[i].characters == "#" && !macro.body[i].is_paste) {
            auto operand = i + 1;
            while (operand < macro.body.size() && is_blank_token(macro.body[operand].characters))
                ++operand;
            auto const index = operand < macro.body.size()
                ? parameter_index(macro, macro.body[operand])
                : macro.parameters.size();
            if (index < macro.parameters.size()) {
                next.push_back({ quoted(call.arguments[index]), call.place, true, false, 0 });
                i = operand;
            } else {
                TRY(substitute_token(macro, call, i, next));
            }
        } else {
            TRY(substitute_token(macro, call, i, next));
        }
        if (pastes && !takes_comma(macro, call, i, result))
            paste(result, next);
        else
            std::move(next.begin(), next.end(), std::back_inserter(result));
        if (result.size() > kMaxTokens)
            return error(call.place, "macros make more than 16 MB of text here");
    }
    return result;
}

// Sets `result` to the replacement of one token of a macro's body: the token itself, or the
// argument if it names a parameter. An argument next to ## is not expanded; if it is empty, the
// result is one empty token.
Result<void> MacroTable::substitute_token(Macro const& macro, Call& call, std::size_t at,
                                          Tokens& result)
{
    auto const index = parameter_index(macro, macro.body[at]);
    if (index == macro.parameters.size()) {
        result.push_back(macro.body[at]);
        result.back().place = call.place;
        return {};
    }
    bool const is_pasted = (at > 0 && macro.body[at - 1].is_paste)
        || (at + 1 < macro.body.size() && macro.body[at + 1].is_paste);
    if (is_pasted) {
        result = call.arguments[index];
        if (result.empty())
            result.push_back({ {}, call.place, true, false, 0 });
        return {};
    }
    TRY(expand_argument(call, index));
    result = call.expanded[index];
    for (auto const& token : result)
        TRY(spend(token.characters.size(), call.place));
    return {};
}

Result<void> MacroTable::expand_argument(Call& call, std::size_t index)
{
    if (call.is_expanded[index])
        return {};
    if (call.depth >= kMaxCallNesting)
        return error(call.place,
                     fmt::format("calls of macros are nested deeper than {}", kMaxCallNesting));
    call.is_expanded[index] = true;
    TRY(spend(call.arguments[index].size() * kTokenCost, call.place));
    Tokens rest(call.arguments[index].rbegin(), call.arguments[index].rend());
    auto& expanded = call.expanded[index];
    return expand(rest, call.depth + 1, [&](Token const& token) -> Result<void> {
        if (expanded.size() >= kMaxTokens)
            return error(token.place, "macros make more than 16 MB of text here");
        expanded.push_back(token);
        return {};
    });
}

// Makes a string literal of an argument, as the operator # does. Runs of blanks become single
// blanks.
std::string MacroTable::quoted(Tokens const& argument)
{
    std::string result = "\"";
    for (auto const& token : argument) {
        if (is_blank_token(token.characters)) {
            if (result.back() != ' ')
                result += ' ';
            continue;
        }
        if (token.characters.empty() || token.characters.front() != '"')
            result += token.characters;
        else
            append_escaped(result, token.characters);
    }
    return result + '"';
}

// Handles a comma before ## and the variable arguments. Returns true for this pair, which is not
// joined, and removes the comma if the call has no variable arguments.
bool MacroTable::takes_comma(Macro const& macro, Call const& call, std::size_t at, Tokens& result)
{
    if (!macro.is_variadic || result.empty() || result.back().characters != ","
        || !result.back().is_in_body
        || parameter_index(macro, macro.body[at]) + 1 != macro.parameters.size())
        return false;
    if (call.leaves_out_rest)
        result.pop_back();
    return true;
}

// Joins the last token of `result` and the first of `next` if the two form one token together;
// otherwise appends `next` unchanged.
void MacroTable::paste(Tokens& result, Tokens const& next)
{
    auto from = next.begin();
    if (!result.empty() && from != next.end()) {
        auto const joined = result.back().characters + from->characters;
        if (joined.empty() || token_end(joined, 0) == joined.size()) {
            result.back().characters = joined;
            result.back().is_in_body = true;
            ++from;
        }
    }
    result.insert(result.end(), from, next.end());
}

} // namespace tractus::lsystem
