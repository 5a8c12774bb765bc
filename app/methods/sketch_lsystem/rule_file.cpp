#include "app/methods/sketch_lsystem/rule_file.h"

#include "calib/toml_table.h"
#include "engine/base/file.h"

#include <array>
#include <fmt/format.h>
#include <limits>

namespace tractus::sketch {

namespace {

struct NumberKey {
    char const* letter;
    double Rule::*value;
};

constexpr std::array kNumbers {
    NumberKey { "l", &Rule::first_length_mm },     NumberKey { "r", &Rule::length_ratio },
    NumberKey { "q", &Rule::width_ratio },         NumberKey { "w", &Rule::first_width_mm },
    NumberKey { "a", &Rule::angle_deg },           NumberKey { "s", &Rule::lateral_length },
    NumberKey { "v", &Rule::lateral_width },       NumberKey { "T", &Rule::axis_twist_deg },
    NumberKey { "t", &Rule::lateral_twist_deg },   NumberKey { "l_min", &Rule::shortest_mm },
    NumberKey { "limit", &Rule::most_internodes }, NumberKey { "o", &Rule::occupancy_radius_mm },
};

struct LateralKey {
    char const* letter;
    double LateralRule::*value;
};

constexpr std::array kLateralNumbers {
    LateralKey { "r", &LateralRule::length_ratio },
    LateralKey { "q", &LateralRule::width_ratio },
    LateralKey { "a", &LateralRule::angle_deg },
    LateralKey { "s", &LateralRule::lateral_length },
    LateralKey { "v", &LateralRule::lateral_width },
    LateralKey { "T", &LateralRule::twist_deg },
    LateralKey { "l_min", &LateralRule::shortest_mm },
};

Result<int> read_count(calib::TomlTable& table, char const* key, int fallback)
{
    if (!table.has(key))
        return fallback;
    auto const count = TRY(table.integer(key));
    if (count < 0 || count > std::numeric_limits<int>::max())
        return table.wrong(key, fmt::format("is {}, which is no count", count));
    return static_cast<int>(count);
}

// Sets the defaults of those missing keys whose default depends on other numbers.
void set_defaults(calib::TomlTable& table, Rule& rule)
{
    constexpr double kSlender = 0.15;
    double const twist_deg = rule.laterals > 0 ? 180.0 / rule.laterals : 0;
    if (!table.has("w"))
        rule.first_width_mm = kSlender * rule.first_length_mm;
    if (!table.has("T"))
        rule.axis_twist_deg = twist_deg;
    if (!table.has("t"))
        rule.lateral_twist_deg = twist_deg;
}

Result<LateralRule> read_lateral_rule(calib::TomlTable& table)
{
    LateralRule rule;
    for (auto const& [letter, value] : kLateralNumbers)
        rule.*value = TRY(table.number_or(letter, rule.*value));
    rule.laterals = TRY(read_count(table, "k", rule.laterals));
    rule.laterals_by = TRY(read_count(table, "by", rule.laterals_by));
    if (!table.has("T"))
        rule.twist_deg = rule.laterals > 0 ? 180.0 / rule.laterals : 0;
    TRY(table.refuse_unknown_keys());
    return rule;
}

} // namespace

Result<Rule> parse_rule(std::string_view text, std::string const& name)
{
    auto table = TRY(calib::TomlTable::parse(text, name));
    Rule rule;
    for (auto const& [letter, value] : kNumbers)
        rule.*value = TRY(table.number_or(letter, rule.*value));
    rule.laterals = TRY(read_count(table, "k", rule.laterals));
    rule.most_segments = TRY(read_count(table, "n_max", rule.most_segments));
    set_defaults(table, rule);
    if (table.has("laterals"))
        for (auto& lateral : TRY(table.tables("laterals")))
            rule.lateral_rules.push_back(TRY(read_lateral_rule(lateral)));
    TRY(table.refuse_unknown_keys());
    if (auto const checked = check_rule(rule); !checked)
        return fail(checked.error().fault, fmt::format("{}: {}", name, checked.error().message));
    return rounded_as_text(rule);
}

Result<Rule> load_rule(std::filesystem::path const& path)
{
    constexpr std::size_t kMaxBytes = std::size_t { 1 } << 16;
    return parse_rule(TRY(read_text_file(path, kMaxBytes)), path.string());
}

} // namespace tractus::sketch
