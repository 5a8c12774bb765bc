#include "engine/scene/season.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/core.h>

namespace tractus::scene {

namespace {

constexpr std::array<std::string_view, 12> kMonths {
    "January", "February", "March",     "April",   "May",      "June",
    "July",    "August",   "September", "October", "November", "December"
};

struct NamedTime {
    std::string_view name;
    double month;
};
constexpr std::array kTimes {
    NamedTime { "buds", 4.2 },    NamedTime { "spring", 4.6 }, NamedTime { "summer", 7.0 },
    NamedTime { "autumn", 10.4 }, NamedTime { "fall", 10.4 },  NamedTime { "bare", 12.0 },
    NamedTime { "winter", 1.5 },
};

bool is_same_word(std::string_view one, std::string_view other)
{
    auto const lower
        = [](char letter) { return letter >= 'A' && letter <= 'Z' ? letter + 32 : letter; };
    return std::ranges::equal(one, other, {}, lower, lower);
}

// Leaf ages at the end of bud burst, at full growth, and at the beginning of senescence.
constexpr double kOpened = 0.06;
constexpr double kGrownUp = 0.45;
constexpr double kTurning = 0.55;

} // namespace

Result<double> parse_month(std::string_view text)
{
    for (auto const& time : kTimes)
        if (is_same_word(text, time.name))
            return time.month;
    for (std::size_t i = 0; i < kMonths.size(); ++i)
        if (is_same_word(text, kMonths[i]))
            return static_cast<double>(i) + 1.5;
    double month = 0;
    auto const* const end = text.data() + text.size();
    auto const read = std::from_chars(text.data(), end, month);
    if (read.ec != std::errc {} || read.ptr != end || !(month >= 1 && month < 13))
        return fail(
            Fault::User,
            fmt::format("there is no season {}: give buds, spring, summer, autumn, winter or "
                        "bare, a month's name, or its number, 1 to below 13 (10.5 is the "
                        "middle of October)",
                        text));
    return month;
}

std::vector<std::string> season_words()
{
    std::vector<std::string> words;
    for (auto const& time : kTimes)
        if (time.name != "fall")
            words.emplace_back(time.name);
    words.insert(words.end(), kMonths.begin(), kMonths.end());
    return words;
}

std::string month_name(double month)
{
    auto const whole = std::clamp(static_cast<int>(std::floor(month)), 1, 12);
    double const part = month - whole;
    auto const* const when = part < 1.0 / 3 ? "early " : part < 2.0 / 3 ? "mid-" : "late ";
    return fmt::format("{}{}", when, kMonths[static_cast<std::size_t>(whole - 1)]);
}

std::optional<double> age_in_season(OrganCalendar const& calendar, double month)
{
    auto const between = [&](double from, double to, double from_age, double to_age) {
        return std::lerp(from_age, to_age, (month - from) / (to - from));
    };
    if (calendar.is_evergreen)
        return kTurning;
    if (month < calendar.opens || month >= calendar.bare)
        return std::nullopt;
    if (month < calendar.grown)
        return between(calendar.opens, calendar.grown, kOpened, kGrownUp);
    if (month < calendar.turns)
        return between(calendar.grown, calendar.turns, kGrownUp, kTurning);
    return between(calendar.turns, calendar.bare, kTurning, 1);
}

} // namespace tractus::scene
