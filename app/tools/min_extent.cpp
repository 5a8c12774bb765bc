#include "app/tools/min_extent.h"

#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <optional>

namespace tractus::tools {

static std::optional<double> read_extent(std::string_view text)
{
    double mm = 0;
    auto const* const end = text.data() + text.size();
    auto const [read, error] = std::from_chars(text.data(), end, mm);
    bool const is_good = error == std::errc() && read == end && mm >= 0 && mm <= kMaxMinExtent_mm;
    return is_good ? std::optional(mm) : std::nullopt;
}

// True for what can be a tool's word, which is written into settings without quoting.
static bool is_tool_word(std::string_view text)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9')
            || letter == '_';
    });
}

MinExtents usual_min_extents(ToolKinds kinds)
{
    MinExtents extents;
    for (auto const* const kind : kinds)
        if (kind->min_extent_mm > 0)
            extents[kind->word] = kind->min_extent_mm;
    return extents;
}

std::string print_min_extents(MinExtents const& extents)
{
    std::string words;
    for (auto const& [kind, mm] : extents)
        words += fmt::format("{}{}={}", words.empty() ? "" : " ", kind, mm);
    return words;
}

Result<MinExtents> parse_min_extents(std::string_view words)
{
    MinExtents extents;
    while (!words.empty()) {
        auto const word = words.substr(0, words.find(' '));
        words.remove_prefix(std::min(word.size() + 1, words.size()));
        if (word.empty())
            continue;
        auto const equals = word.find('=');
        auto const mm = equals == std::string_view::npos || !is_tool_word(word.substr(0, equals))
            ? std::nullopt
            : read_extent(word.substr(equals + 1));
        if (!mm)
            return fail(Fault::User,
                        fmt::format("\"{}\" is no least extent of a tool: write its word and "
                                    "millimetres from 0 to {:g}, for example draw=6",
                                    word, kMaxMinExtent_mm));
        extents[std::string(word.substr(0, equals))] = *mm;
    }
    return extents;
}

double min_extent_mm(MinExtents const& extents, ToolKind const& kind)
{
    auto const found = extents.find(std::string_view(kind.word));
    return found == extents.end() ? 0 : found->second;
}

double extent_mm(Stroke const& stroke)
{
    double farthest_mm = 0;
    for (auto const& tip : stroke.tips)
        farthest_mm
            = std::max(farthest_mm, (tip.position_mm - stroke.tips.front().position_mm).norm());
    return farthest_mm;
}

std::string describe_dab(ToolKind const& kind, double min_mm)
{
    return fmt::format("A stroke of less than {:g} mm says nothing to \"{}\": nothing is done",
                       min_mm, kind.title);
}

} // namespace tractus::tools
