#include "app/methods/construction_lines/read_json_organs.h"

#include "app/methods/construction_lines/read_json_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>

namespace tractus::lines {

using nlohmann::json;

namespace {

constexpr std::array kOrganKeys { "left", "right", "midrib", "section" };

// "whorled(N)" or "whorled", of three.
std::optional<int> whorl_of(std::string_view word)
{
    constexpr std::string_view kWhorled = "whorled";
    if (!word.starts_with(kWhorled))
        return std::nullopt;
    word.remove_prefix(kWhorled.size());
    if (word.empty())
        return Pattern().whorl;
    if (!word.starts_with('(') || !word.ends_with(')'))
        return std::nullopt;
    word = word.substr(1, word.size() - 2);
    int count = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || end != word.data() + word.size() || count < 2 || count > 24)
        return std::nullopt;
    return count;
}

Result<Pattern> read_pattern_word(json const& file)
{
    constexpr std::string_view kWhatToGive = "give \"distichous\", \"decussate\", \"spiral\", "
                                             "\"alternate\", or \"whorled(N)\" with N from 2 to 24";
    if (!has_value(file, "pattern") || !file["pattern"].is_string())
        return fail(Fault::User, fmt::format("pattern is missing: {}", kWhatToGive));
    auto const& word = file["pattern"].get_ref<std::string const&>();
    Pattern pattern;
    if (auto const count = whorl_of(word)) {
        pattern.kind = Pattern::Kind::Whorled;
        pattern.whorl = *count;
        return pattern;
    }
    using enum Pattern::Kind;
    for (auto const kind : { Distichous, Decussate, Spiral, Alternate })
        if (word == name_of(kind)) {
            pattern.kind = kind;
            return pattern;
        }
    return fail(Fault::User, fmt::format("pattern is \"{}\": {}", word.substr(0, 40), kWhatToGive));
}

Result<Pattern::Sizes> read_sizes(json const& file)
{
    if (!has_value(file, "sizes") || file["sizes"] == "linear")
        return Pattern::Sizes::Linear;
    if (file["sizes"] == "half-ellipses")
        return Pattern::Sizes::HalfEllipses;
    return fail(Fault::User,
                "sizes is no way to change around the stem: give \"linear\" or "
                "\"half-ellipses\"");
}

} // namespace

Result<Pattern> read_pattern(json const& file)
{
    auto pattern = TRY(read_pattern_word(file));
    pattern.sizes = TRY(read_sizes(file));
    if (pattern.kind == Pattern::Kind::Alternate)
        pattern.divergence_deg = 180;
    if (!has_value(file, "divergence"))
        return pattern;
    auto const& value = file["divergence"];
    double const divergence_deg = value.is_number() ? value.get<double>() : std::nan("");
    if (!(std::fabs(divergence_deg) <= 360))
        return fail(Fault::User, "divergence is no angle: give degrees from -360 to 360");
    if (pattern.kind == Pattern::Kind::Spiral || pattern.kind == Pattern::Kind::Alternate)
        pattern.divergence_deg = divergence_deg;
    return pattern;
}

Result<std::vector<std::string>> read_organs(json const& file)
{
    std::vector<std::string> organs;
    if (!has_value(file, "organs"))
        return organs;
    auto const list = file["organs"].is_array() ? file["organs"] : json::array({ file["organs"] });
    for (auto const& organ : list) {
        if (!organ.is_null() && !organ.is_string())
            return fail(Fault::User,
                        "organs are no sketches: write [\"leaf.json\", null], for each layer from "
                        "below the file of a sketch, or null for leaves");
        organs.push_back(organ.is_null() ? "" : organ.get<std::string>());
    }
    return organs;
}

Result<std::optional<OrganViews>> read_organ(json const& file)
{
    if (!has_value(file, "organ"))
        return std::nullopt;
    auto const& organ = file["organ"];
    if (!organ.is_object())
        return fail(Fault::User,
                    "organ is no leaf's shape: write {\"left\": [[u, v], [u, v]], \"right\": …, "
                    "\"midrib\": …, \"section\": …}");
    for (auto const& [key, value] : organ.items())
        if (std::find(kOrganKeys.begin(), kOrganKeys.end(), key) == kOrganKeys.end())
            return fail(
                Fault::User,
                fmt::format("organ has no line \"{}\": give left, right, midrib and section",
                            key.substr(0, 40)));
    OrganViews views;
    std::array const lines { &views.left, &views.right, &views.midrib, &views.section };
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (has_value(organ, kOrganKeys[i]))
            *lines[i] = TRY(read_flat_line(organ[kOrganKeys[i]],
                                           fmt::format("{} of the organ", kOrganKeys[i])));
    TRY(organ_surface(views)); // Fails where there is none.
    return views;
}

} // namespace tractus::lines
