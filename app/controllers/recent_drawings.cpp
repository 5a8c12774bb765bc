#include "app/controllers/recent_drawings.h"

#include "app/batch/session_plant.h"
#include "app/controllers/drawing_name.h"
#include "app/session/session_copy.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <fmt/chrono.h>
#include <fmt/core.h>
#include <system_error>

namespace tractus::controllers {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;

namespace {

std::tm local_time(sys_seconds time)
{
    return fmt::localtime(std::chrono::system_clock::to_time_t(time));
}

// Returns the calendar day of a local time.
std::chrono::sys_days day_of(std::tm const& time)
{
    return std::chrono::sys_days(std::chrono::year(time.tm_year + 1900)
                                 / std::chrono::month(static_cast<unsigned>(time.tm_mon + 1))
                                 / std::chrono::day(static_cast<unsigned>(time.tm_mday)));
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

sys_seconds modification_time(fs::path const& file)
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
        if (batch::is_session_file(entry->path()))
            found.emplace_back(modification_time(entry->path()), entry->path());
    std::sort(found.begin(), found.end(), std::greater<>());
    found.resize(std::min(found.size(), most));
    std::vector<RecentDrawing> recent;
    for (auto const& [time, file] : found)
        recent.push_back(
            { file, name_of_drawing(file, session::session_name(file)), time_in_words(time, now) });
    return recent;
}

} // namespace tractus::controllers
