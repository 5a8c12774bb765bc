#include "app/options/checks.h"

#include "calib/height_scenario.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace tractus::options {

namespace {

template<typename Number> std::optional<Number> parse(std::string const& text)
{
    Number value {};
    char const* const end = text.data() + text.size();
    auto const result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
        return std::nullopt;
    return value;
}

// Makes a validator without a description. CLI11 would show a description beside the option's type,
// but the help texts already explain the checks.
CLI::Validator check(std::function<std::string(std::string const&)> problem)
{
    return { [problem = std::move(problem)](std::string& text) { return problem(text); }, "" };
}

} // namespace

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most)
{
    return check([=](std::string const& text) {
        auto const value = parse<std::uint64_t>(text);
        return value && *value >= least && *value <= most
            ? std::string()
            : fmt::format("'{}' is not a whole number from {} to {}", text, least, most);
    });
}

CLI::Validator seed_number()
{
    return whole_number(0, std::numeric_limits<std::uint64_t>::max());
}

CLI::Validator number(double least, double most)
{
    return check([=](std::string const& text) {
        auto const value = parse<double>(text);
        return value && *value >= least && *value <= most
            ? std::string()
            : fmt::format("'{}' is not a number from {:g} to {:g}", text, least, most);
    });
}

// Parses two numbers with `separator` between them; nullopt for any other text.
template<typename Number>
static std::optional<std::pair<Number, Number>> parse_pair(std::string const& text,
                                                           std::string_view separator)
{
    auto const at = text.find(separator);
    if (at == std::string::npos)
        return std::nullopt;
    auto const first = parse<Number>(text.substr(0, at));
    auto const second = parse<Number>(text.substr(at + separator.size()));
    return first && second ? std::optional(std::pair(*first, *second)) : std::nullopt;
}

std::optional<std::pair<double, double>> parse_range(std::string const& text)
{
    if (auto const one = parse<double>(text))
        return std::pair(*one, *one);
    return parse_pair<double>(text, "..");
}

CLI::Validator number_range(double least, double most)
{
    return check([=](std::string const& text) {
        auto const range = parse_range(text);
        return range && range->first >= least && range->first <= range->second
                && range->second <= most
            ? std::string()
            : fmt::format("'{}' is not a range within {:g}..{:g}, such as {:g}..{:g}", text, least,
                          most, (least + most) / 2, most);
    });
}

std::optional<std::pair<std::size_t, std::size_t>> parse_part(std::string const& text)
{
    return parse_pair<std::size_t>(text, "/");
}

CLI::Validator part_of(std::size_t most)
{
    return check([=](std::string const& text) {
        auto const part = parse_part(text);
        return part && part->first >= 1 && part->first <= part->second && part->second <= most
            ? std::string()
            : fmt::format("'{}' is not a part of at most {}, such as 2/8 for the second of eight",
                          text, most);
    });
}

CLI::Validator one_of(std::vector<std::string> const& words)
{
    return with_completion_words(
        words, check([words](std::string const& text) {
            return std::find(words.begin(), words.end(), text) != words.end()
                ? std::string()
                : fmt::format("'{}' is none of {}", text, fmt::join(words, ", "));
        }));
}

CLI::Validator suggest(std::vector<std::string> const& words)
{
    return with_completion_words(words, check([](std::string const&) { return std::string(); }));
}

// Prefix of validators' names that contain words for shell completion. The name is the only text of
// a validator that CLI11 returns from an option.
static constexpr std::string_view kOffers = "offers\n";

CLI::Validator with_completion_words(std::vector<std::string> const& words, CLI::Validator check)
{
    return std::move(check.name(fmt::format("{}{}", kOffers, fmt::join(words, "\n"))));
}

std::vector<std::string> completion_words(CLI::Option& option)
{
    std::vector<std::string> words;
    for (int i = 0;; ++i)
        try {
            auto const& name = option.get_validator(i)->get_name();
            if (name.compare(0, kOffers.size(), kOffers) == 0)
                words = CLI::detail::split(name.substr(kOffers.size()), '\n');
        } catch (CLI::OptionNotFound const&) {
            return words; // All validators of the option have been examined.
        }
}

CLI::Validator name_ending_in(std::vector<std::string> endings)
{
    return check([endings = std::move(endings)](std::string const& text) {
        auto const ending = std::filesystem::path(text).extension().string();
        return std::find(endings.begin(), endings.end(), ending) != endings.end()
            ? std::string()
            : fmt::format("the name '{}' must end in {}", text, fmt::join(endings, " or "));
    });
}

CLI::Validator picture_name()
{
    return check([](std::string const& text) {
        auto const ending = std::filesystem::path(text).extension();
        return ending.empty() || ending == ".png"
            ? std::string()
            : fmt::format("the name '{}' must end in .png, since that is what is written", text);
    });
}

CLI::Validator height_scenario()
{
    return with_completion_words({ "rise", "fall", "arch", "sway" },
                                 check([](std::string const& text) {
                                     auto const scenario = calib::parse_height_scenario(text);
                                     return scenario ? std::string() : scenario.error().message;
                                 }));
}

} // namespace tractus::options
