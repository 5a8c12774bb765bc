#include "app/session/new_session_file.h"

#include "engine/base/file.h"
#include "engine/base/unfinished_file.h"

#include <cerrno>
#include <cstring>
#include <fmt/core.h>
#include <unistd.h>

namespace tractus::session {

namespace fs = std::filesystem;

static tl::unexpected<Error> already_there(fs::path const& path)
{
    return fail(Fault::User,
                fmt::format("{} is already there: choose another name, a session is never written "
                            "over",
                            path.string()));
}

// Gives the complete file `made` its final name `path`. Fails if a file with that name exists.
static Result<void> appear(fs::path const& made, fs::path const& path)
{
    // Creating a hard link fails if the name is taken, while renaming would overwrite the file.
    bool const is_linked = ::link(made.c_str(), path.c_str()) == 0;
    int const reason = errno;
    std::error_code ignored;
    if (!is_linked && reason != EEXIST && !fs::exists(path, ignored)) {
        if (rename_on_disk(made, path)) // Fallback for file systems without hard links.
            return {};
    }
    fs::remove(made, ignored);
    flush_name_to_disk(path);
    if (is_linked)
        return {};
    return reason == EEXIST
        ? already_there(path)
        : fail(Fault::User,
               fmt::format("cannot write {}: {}", path.string(), std::strerror(reason)));
}

Result<void> make_session_file(fs::path const& path,
                               std::function<Result<void>(fs::path const& made)> const& write)
{
    std::error_code ignored;
    if (fs::exists(path, ignored))
        return already_there(path);
    TRY(check_writable(path));
    if (path.has_parent_path())
        TRY(make_folder(path.parent_path()));
    auto const made = unfinished_path(path);
    if (auto const written = write(made); !written) {
        // Removes the unfinished file and SQLite's files beside it.
        for (auto const* const ending : { "", "-wal", "-shm" })
            fs::remove(made.string() + ending, ignored);
        return fail(
            Fault::User,
            fmt::format("cannot begin the session {}: {}", path.string(), written.error().message));
    }
    return appear(made, path);
}

} // namespace tractus::session
