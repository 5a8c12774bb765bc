#include "app/unnamed_session.h"

#include "app/session/session_file.h"

#include <cstdlib>
#include <fmt/chrono.h>
#include <string_view>

namespace tractus {

namespace fs = std::filesystem;

// Empty where the user has none. What is no absolute path does not count: so the specification.
static fs::path data_folder()
{
    auto const folder = [](char const* variable) -> fs::path {
        char const* const value = std::getenv(variable); // NOLINT(concurrency-mt-unsafe): nobody
                                                         // changes the environment.
        return value != nullptr && *value == '/' ? value : "";
    };
    if (auto const data = folder("XDG_DATA_HOME"); !data.empty())
        return data / "tractus";
    auto const home = folder("HOME");
    return home.empty() ? home : home / ".local" / "share" / "tractus";
}

Result<fs::path> unnamed_session_path(std::string const& plant, std::chrono::sys_seconds now)
{
    auto const folder = data_folder();
    if (folder.empty())
        return fail(Fault::User, "there is no home folder to keep a session in: give --session");
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return fail(Fault::User,
                    fmt::format("cannot make the folder {}: {}; give --session", folder.string(),
                                error.message()));
    auto const name = fmt::format("{}-{:%Y-%m-%d-%H%M}", plant,
                                  fmt::localtime(std::chrono::system_clock::to_time_t(now)));
    auto path = folder / (name + ".tractus");
    for (int number = 2; fs::exists(path, error); ++number)
        path = folder / fmt::format("{}-{}.tractus", name, number);
    return path;
}

void remove_if_nothing_was_drawn(fs::path const& session)
{
    auto const contents = read_session(session);
    std::error_code ignored;
    if (contents && contents->last_step() == 0)
        fs::remove(session, ignored);
}

} // namespace tractus
