#include "app/methods/self_organising/habit_text.h"

#include "calib/toml_table.h"
#include "engine/plant/bark.h"

#include <filesystem>
#include <fmt/format.h>

namespace tractus::self_organising {

namespace {

// A number of a habit that defaults to another number of the habit.
struct Follows {
    double Habit::*value;
    double Habit::*other;
    char const* key;
};
constexpr Follows kFollows[] {
    { &Habit::most_internodes_old, &Habit::most_internodes, "most_internodes_old" },
    { &Habit::branch_internodes, &Habit::most_internodes, "branch_internodes" },
    { &Habit::twig_internodes, &Habit::branch_internodes, "twig_internodes" },
    { &Habit::vigour_old, &Habit::vigour, "vigour_old" },
    { &Habit::apical_control_old, &Habit::apical_control, "apical_control_old" },
    { &Habit::shed_below_old, &Habit::shed_below, "shed_below_old" },
    { &Habit::lateral_angle_deg, &Habit::angle_deg, "lateral_angle_deg" },
    { &Habit::lateral_divergence_deg, &Habit::divergence_deg, "lateral_divergence_deg" },
    { &Habit::tropism_branches, &Habit::tropism_trunk, "tropism_branches" },
    { &Habit::tropism_twigs, &Habit::tropism_branches, "tropism_twigs" },
    { &Habit::tropism_last, &Habit::tropism_twigs, "tropism_last" },
};

// Reads the kind of bark, and takes its colour, which numbers of the habit may change.
Result<void> read_bark(calib::TomlTable& table, Habit& habit)
{
    auto const kind
        = static_cast<BarkKind>(TRY(table.word("bark", { kBarkNames.begin(), kBarkNames.end() })));
    habit.bark = bark_name(kind);
    Vec3f const color = bark_color({ kind, BarkAge::Old });
    habit.bark_red = double { color.x() };
    habit.bark_green = double { color.y() };
    habit.bark_blue = double { color.z() };
    return {};
}

} // namespace

Result<Habit> parse_habit(std::string_view text, std::string const& name)
{
    auto table = TRY(calib::TomlTable::parse(text, name));
    Habit habit { .name = std::filesystem::path(name).stem().string() };
    if (table.has("latin"))
        habit.latin = TRY(table.text("latin"));
    if (table.has("leaves"))
        habit.leaves = TRY(table.text("leaves"));
    if (table.has("bark"))
        TRY(read_bark(table, habit));
    for (auto const& number : habit_numbers())
        habit.*number.value = TRY(table.number_or(number.key, habit.*number.value));
    for (auto const& [value, other, key] : kFollows)
        if (!table.has(key))
            habit.*value = habit.*other;
    TRY(table.refuse_unknown_keys());
    if (auto const checked = check_habit(habit); !checked)
        return fail(Fault::User, fmt::format("{}: {}", name, checked.error().message));
    return habit;
}

} // namespace tractus::self_organising
