#include "app/live/recent_drawings.h"

#include "app/plants/session_plant.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <system_error>

namespace tractus {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;

namespace {

std::tm local_time(sys_seconds time)
{
    return fmt::localtime(std::chrono::system_clock::to_time_t(time));
}

// Its day, counted as if there were no time zones.
std::chrono::sys_days day_of(std::tm const& time)
{
    return std::chrono::sys_days(std::chrono::year(time.tm_year + 1900)
                                 / std::chrono::month(static_cast<unsigned>(time.tm_mon + 1))
                                 / std::chrono::day(static_cast<unsigned>(time.tm_mday)));
}

// Takes "-" and a number off the end; false if they are not there, or the number has not so many
// digits.
bool take_number(std::string_view& name, std::optional<std::size_t> digits = std::nullopt)
{
    auto const last = name.find_last_not_of("0123456789");
    if (last == std::string_view::npos || name[last] != '-')
        return false;
    auto const found = name.size() - last - 1;
    if (found == 0 || found != digits.value_or(found))
        return false;
    name.remove_suffix(found + 1);
    return true;
}

// Without the time that unnamed_session_path() puts behind it, and the number behind that.
std::string plant_of(std::string const& stem)
{
    for (bool const numbered : { false, true }) {
        std::string_view plant = stem;
        if (numbered && !take_number(plant))
            continue;
        if (take_number(plant, 4) && take_number(plant, 2) && take_number(plant, 2)
            && take_number(plant, 4) && !plant.empty())
            return std::string(plant);
    }
    return stem;
}

} // namespace

std::string time_in_words(sys_seconds time, sys_seconds now)
{
    static constexpr std::array kMonths { "January",   "February", "March",    "April",
                                          "May",       "June",     "July",     "August",
                                          "September", "October",  "November", "December" };
    auto const then = local_time(time);
    auto const today = local_time(now);
    auto const days = (day_of(today) - day_of(then)).count();
    auto const clock = fmt::format("{}:{:02}", then.tm_hour, then.tm_min);
    if (days == 0)
        return "Today, " + clock;
    if (days == 1)
        return "Yesterday, " + clock;
    auto const date
        = fmt::format("{} {}", then.tm_mday, kMonths.at(static_cast<std::size_t>(then.tm_mon)));
    return then.tm_year == today.tm_year ? fmt::format("{}, {}", date, clock)
                                         : fmt::format("{} {}", date, then.tm_year + 1900);
}

std::string name_in_words(std::string stem)
{
    std::replace(stem.begin(), stem.end(), '_', ' ');
    if (!stem.empty())
        stem.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(stem.front())));
    return stem;
}

sys_seconds written_last(fs::path const& file)
{
    std::error_code error;
    auto last = fs::last_write_time(file, error);
    if (error)
        return {};
    auto const beside = fs::last_write_time(file.string() + "-wal", error);
    if (!error)
        last = std::max(last, beside);
    return std::chrono::floor<std::chrono::seconds>(fs::file_time_type::clock::to_sys(last));
}

std::vector<RecentDrawing> recent_drawings(fs::path const& folder, std::size_t most,
                                           sys_seconds now)
{
    std::vector<std::pair<sys_seconds, fs::path>> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
        if (is_session_file(entry->path()))
            found.emplace_back(written_last(entry->path()), entry->path());
    std::sort(found.begin(), found.end(), std::greater<>());
    found.resize(std::min(found.size(), most));
    std::vector<RecentDrawing> recent;
    for (auto const& [time, file] : found)
        recent.push_back(
            { file, name_in_words(plant_of(file.stem().string())), time_in_words(time, now) });
    return recent;
}

} // namespace tractus
