#include "app/methods/self_organising/habit_file.h"

#include "app/files/resources.h"
#include "calib/toml_table.h"
#include "engine/base/file.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace tractus::self_organising {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t { 1 } << 16;
constexpr char const* kEnding = ".habit";

// Which number a missing one follows.
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

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

Result<Habit> load_file(fs::path const& path)
{
    return parse_habit(TRY(read_text_file(path, kMostBytes)), path.string());
}

} // namespace

Result<Habit> parse_habit(std::string_view text, std::string const& name)
{
    auto table = TRY(calib::TomlTable::parse(text, name));
    Habit habit { .name = fs::path(name).stem().string() };
    if (table.has("latin"))
        habit.latin = TRY(table.text("latin"));
    if (table.has("leaves"))
        habit.leaves = TRY(table.text("leaves"));
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

std::vector<std::string> habit_names()
{
    return files::resource_names("habits", kEnding);
}

Result<Habit> load_habit(std::string const& name)
{
    std::error_code error;
    if (fs::is_regular_file(name, error))
        return load_file(name);
    auto const folder = TRY(files::find_resource("habits"));
    auto const ours = habit_names();
    for (auto const& known : ours)
        if (known == lower_case(name))
            return load_file(folder / (known + kEnding));
    for (auto const& known : ours) {
        auto habit = TRY(load_file(folder / (known + kEnding)));
        if (lower_case(habit.latin) == lower_case(name))
            return habit;
    }
    return fail(Fault::User,
                fmt::format("there is no habit {}: give the path of a .habit file, or one of {}",
                            name, fmt::join(ours, ", ")));
}

} // namespace tractus::self_organising
