#include "app/methods/self_organising/habit_file.h"

#include "app/files/resources.h"
#include "app/methods/self_organising/habit_text.h"
#include "engine/base/file.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace tractus::self_organising {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxHabitBytes = std::size_t { 1 } << 16;
constexpr char const* kEnding = ".habit";

std::string lower_case(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

Result<Habit> load_file(fs::path const& path)
{
    return parse_habit(TRY(read_text_file(path, kMaxHabitBytes)), path.string());
}

} // namespace

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
