#include "app/verbs/checks.h"

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

namespace tractus {

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

// The parser shows a validator's description beside the option's type; ours are in the texts.
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

CLI::Validator one_of(std::vector<std::string> words)
{
    return check([words = std::move(words)](std::string const& text) {
        return std::find(words.begin(), words.end(), text) != words.end()
            ? std::string()
            : fmt::format("'{}' is none of {}", text, fmt::join(words, ", "));
    });
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
    return check([](std::string const& text) {
        auto const scenario = parse_height_scenario(text);
        return scenario ? std::string() : scenario.error().message;
    });
}

} // namespace tractus
