#include "engine/methods/construction_lines/own_rules.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fmt/format.h>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::lines {

namespace {

// A number or array in a model's text whose value comes from the sketch: its name, and the range of
// its value in the text.
struct Value {
    // Name of the value, such as "array at", "#define LEN" or "derivation length:".
    std::string name;
    std::size_t begin = 0;
    std::size_t end = 0;
};

bool begins_word(std::string_view text, std::size_t at)
{
    return at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
}

std::size_t behind_word(std::string_view text, std::size_t at)
{
    while (at < text.size()
           && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_'))
        ++at;
    return at;
}

std::size_t behind_blanks(std::string_view text, std::size_t at)
{
    return std::min(text.find_first_not_of(" \t", at), text.size());
}

// Finds the value of "array NAME[N] = {...}": the text after NAME, from "[" to "}".
void add_array(std::vector<Value>& values, std::string_view text, std::size_t word)
{
    auto const name = behind_blanks(text, word + std::string_view("array").size());
    auto const begin = behind_word(text, name);
    auto const end = text.find('}', begin);
    if (end == std::string_view::npos || begin == name)
        return;
    values.push_back({ fmt::format("array {}", text.substr(name, begin - name)), begin, end + 1 });
}

// Finds the value of "#define NAME VALUE", without a comment after it.
void add_definition(std::vector<Value>& values, std::string_view text, std::size_t word)
{
    auto const name = behind_blanks(text, word + std::string_view("#define").size());
    auto const name_end = behind_word(text, name);
    auto const begin = behind_blanks(text, name_end);
    auto const line_end = std::min(text.find('\n', begin), text.size());
    auto const comment = std::min(text.find("/*", begin), line_end);
    auto const last = text.find_last_not_of(" \t\r", comment - 1);
    if (begin < comment && begin > name_end)
        values.push_back(
            { fmt::format("#define {}", text.substr(name, name_end - name)), begin, last + 1 });
}

void add_steps(std::vector<Value>& values, std::string_view text, std::size_t word)
{
    constexpr std::string_view kSteps = "derivation length:";
    auto const begin = behind_blanks(text, word + kSteps.size());
    values.push_back({ std::string(kSteps), begin, behind_word(text, begin) });
}

// Finds all numbers and arrays in a model's text that may come from the sketch, in order.
std::vector<Value> values_in(std::string_view text)
{
    std::vector<Value> values;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (!begins_word(text, at))
            continue;
        auto const rest = text.substr(at);
        if (rest.starts_with("array "))
            add_array(values, text, at);
        else if (rest.starts_with("#define "))
            add_definition(values, text, at);
        else if (rest.starts_with("derivation length:"))
            add_steps(values, text, at);
    }
    return values;
}

} // namespace

Result<LineModel> with_own_rules(LineModel model, scene::SourceRules const& rules)
{
    std::string_view const drawn = model.source.text;
    // Several L-systems may have arrays of the same name. Those of the two texts correspond in
    // their order.
    std::map<std::string, std::vector<std::string>> texts;
    for (auto const& value : values_in(drawn))
        texts[value.name].emplace_back(drawn.substr(value.begin, value.end - value.begin));
    std::map<std::string, std::size_t> used;
    std::string text;
    std::size_t at = 0;
    for (auto const& value : values_in(rules.text)) {
        auto const known = texts.find(value.name);
        auto const number = used[value.name]++;
        if (known == texts.end() || number >= known->second.size())
            continue; // This value was added by the user and does not come from the sketch.
        text.append(rules.text, at, value.begin - at).append(known->second[number]);
        at = value.end;
    }
    text.append(rules.text, at, std::string::npos);
    for (auto const& [name, values] : texts)
        if (name.starts_with("array ") && used[name] < values.size())
            return fail(Fault::User,
                        fmt::format("the rules that were written have no \"{}\", which the sketch "
                                    "has: write it as the pattern's rules do, or go back to those",
                                    name));
    model.source.text = std::move(text);
    if (!rules.view_text.empty())
        model.source.view_text = rules.view_text;
    return model;
}

} // namespace tractus::lines
