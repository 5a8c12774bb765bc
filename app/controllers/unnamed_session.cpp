#include "app/controllers/unnamed_session.h"

#include "app/files/user_folder.h"
#include "app/session/session_file.h"

#include <fmt/chrono.h>

namespace tractus::controllers {

namespace fs = std::filesystem;

Result<fs::path> unnamed_session_path(std::string const& plant, std::chrono::sys_seconds now)
{
    auto const folder = TRY(files::make_user_folder("give --session, where a session is kept"));
    std::error_code error;
    auto const name = fmt::format("{}-{:%Y-%m-%d-%H%M}", plant,
                                  fmt::localtime(std::chrono::system_clock::to_time_t(now)));
    auto path = folder / (name + ".tractus");
    for (int number = 2; fs::exists(path, error); ++number)
        path = folder / fmt::format("{}-{}.tractus", name, number);
    return path;
}

void remove_if_nothing_was_drawn(fs::path const& session)
{
    auto const contents = session::read_session(session, {});
    std::error_code ignored;
    if (contents && contents->last_step() == 0)
        // Deletes the session's file and the files that SQLite creates beside it.
        for (auto const* const ending : { "", "-wal", "-shm" })
            fs::remove(session.string() + ending, ignored);
}

} // namespace tractus::controllers
