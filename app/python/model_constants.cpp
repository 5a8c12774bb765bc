#include "app/python/model_constants.h"

#include "engine/base/nearest_word.h"
#include "engine/lsystem/text/placed_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <system_error>
#include <vector>

namespace tractus::python {

namespace {

// A line "#define NAME NUMBER", perhaps with a comment behind it.
struct ConstantLine {
    std::string_view name;
    std::string_view number; // A part of the line.
    double value = 0;
};

// Returns the rest of a text that begins with a word and, unless the word is "#", a blank behind
// it.
std::optional<std::string_view> rest_after(std::string_view word, std::string_view text)
{
    if (!text.starts_with(word))
        return std::nullopt;
    text.remove_prefix(word.size());
    if (word != "#" && (text.empty() || !lsystem::is_blank(text.front())))
        return std::nullopt;
    return lsystem::trimmed_line(text);
}

std::optional<ConstantLine> read_constant_line(std::string_view line)
{
    auto const directive = rest_after("#", lsystem::trimmed_line(line));
    auto const definition = directive ? rest_after("define", *directive) : std::nullopt;
    if (!definition)
        return std::nullopt;
    ConstantLine constant { .name = lsystem::first_name(*definition), .number = {} };
    auto const value = rest_after(constant.name, *definition);
    if (constant.name.empty() || !value)
        return std::nullopt;
    auto const comment = std::min(value->find("//"), value->find("/*"));
    constant.number = lsystem::trimmed_line(value->substr(0, comment));
    auto digits = constant.number;
    if (digits.starts_with('+'))
        digits.remove_prefix(1);
    auto const* const end = digits.data() + digits.size();
    auto const [read_to, error] = std::from_chars(digits.data(), end, constant.value);
    if (error != std::errc() || read_to != end)
        return std::nullopt;
    return constant;
}

// Returns the lines of a text without their line ends; joined by these they are the text.
std::vector<std::string_view> lines_of(std::string_view text)
{
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin <= text.size();) {
        auto const end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

Result<void> check_constants(std::string const& name, Constants const& known,
                             Constants const& wanted)
{
    std::vector<std::string> names;
    for (auto const& [constant, value] : known)
        names.push_back(constant);
    for (auto const& [constant, value] : wanted) {
        if (!known.contains(constant))
            return fail(Fault::User,
                        fmt::format("{}: there is no constant {}{}: {}", name, constant,
                                    did_you_mean(constant, names),
                                    names.empty()
                                        ? "no line is \"#define NAME NUMBER\""
                                        : fmt::format("it has {}", fmt::join(names, ", "))));
        if (!std::isfinite(value))
            return fail(Fault::User,
                        fmt::format("{}: the constant {} is {}: give a finite number", name,
                                    constant, value));
    }
    return {};
}

} // namespace

Constants constants_of(std::string_view rules)
{
    Constants constants;
    for (auto const line : lines_of(rules))
        if (auto const constant = read_constant_line(line))
            constants[std::string(constant->name)] = constant->value;
    return constants;
}

Result<std::string> with_constants(std::string const& name, std::string_view rules,
                                   Constants const& constants)
{
    TRY(check_constants(name, constants_of(rules), constants));
    std::string result;
    for (auto const line : lines_of(rules)) {
        if (!result.empty() || line.data() != rules.data())
            result += '\n';
        auto const constant = read_constant_line(line);
        auto const found = constant ? constants.find(constant->name) : constants.end();
        if (found == constants.end()) {
            result += line;
            continue;
        }
        auto const before = static_cast<std::size_t>(constant->number.data() - line.data());
        result += line.substr(0, before);
        result += fmt::format("{}", found->second);
        result += line.substr(before + constant->number.size());
    }
    return result;
}

} // namespace tractus::python
