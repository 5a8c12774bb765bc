#include "sim/unkindness_table.h"

#include <fmt/core.h>

namespace tractus::sim {

namespace {

Result<double> at_most(calib::TomlTable& table, std::string_view key, double most)
{
    double const number = TRY(table.number_or(key, 0, calib::NumberRange::NotNegative));
    if (number > most)
        return table.wrong(key, fmt::format("is {}, expected 0 to {}", number, most));
    return number;
}

Result<Duration> milliseconds(calib::TomlTable& table, std::string_view key)
{
    constexpr double kLongest_ms = 60'000;
    return from_seconds(TRY(at_most(table, key, kLongest_ms)) / 1000);
}

Result<void> parse_hooks(calib::TomlTable& table, Unkindness& unkindness)
{
    constexpr double kLongest_mm = 20;
    Vec2 const hooks_mm = TRY(table.vec2_or("hooks_mm", Vec2::Zero()));
    if (hooks_mm.x() < 0 || hooks_mm.y() < hooks_mm.x() || hooks_mm.y() > kLongest_mm)
        return table.wrong("hooks_mm",
                           fmt::format("is [{}, {}], expected the least and the greatest length, "
                                       "0 to {}",
                                       hooks_mm.x(), hooks_mm.y(), kLongest_mm));
    unkindness.min_hook_mm = hooks_mm.x();
    unkindness.most_hook_mm = hooks_mm.y();
    return {};
}

Result<void> parse_wrong_readings(calib::TomlTable& table, Unkindness& unkindness)
{
    constexpr std::int64_t kMax = 1000;
    unkindness.wrong_period = TRY(milliseconds(table, "wrong_every_ms"));
    if (!table.has("wrong_in_a_row"))
        return {};
    auto const most = TRY(table.integer("wrong_in_a_row", calib::NumberRange::Positive));
    if (most > kMax)
        return table.wrong("wrong_in_a_row", fmt::format("is {}, expected 1 to {}", most, kMax));
    unkindness.most_wrong_in_a_row = static_cast<int>(most);
    return {};
}

Result<void> parse_stalls(calib::TomlTable& table, Unkindness& unkindness)
{
    unkindness.stall = TRY(milliseconds(table, "stall_ms"));
    unkindness.stall_period = TRY(milliseconds(table, "stall_every_ms"));
    if (unkindness.stall > Duration(0) && unkindness.stall >= unkindness.stall_period)
        return table.wrong("stall_ms", "has to be less than stall_every_ms");
    return {};
}

} // namespace

Result<Unkindness> parse_unkindness(calib::TomlTable& table, std::uint64_t seed)
{
    constexpr double kMaxTremor_mm = 5;
    constexpr double kMaxLost = 0.95;
    Unkindness unkindness { .seed = seed };
    TRY(parse_hooks(table, unkindness));
    unkindness.dab_share = TRY(at_most(table, "dab_share", 1));
    unkindness.tremor_mm = TRY(at_most(table, "tremor_mm", kMaxTremor_mm));
    if (table.has("reports"))
        unkindness.reports_changes_only = TRY(table.word("reports", { "all", "changes" })) == 1;
    unkindness.skipped_share = TRY(at_most(table, "lost_share", kMaxLost));
    unkindness.batch_period = TRY(milliseconds(table, "batch_ms"));
    TRY(parse_wrong_readings(table, unkindness));
    TRY(parse_stalls(table, unkindness));
    TRY(table.refuse_unknown_keys());
    return unkindness;
}

} // namespace tractus::sim
