#include "app/session/session.h"

#include "engine/base/check.h"

#include <cerrno>
#include <cstring>
#include <fmt/core.h>
#include <functional>
#include <unistd.h>
#include <utility>

namespace tractus {

namespace fs = std::filesystem;

namespace {

// Puts a whole file under its name, if nothing is there.
Result<void> appear(fs::path const& made, fs::path const& path)
{
    // A link, since renaming would write over what is there.
    bool const is_linked = ::link(made.c_str(), path.c_str()) == 0;
    int const reason = errno;
    std::error_code ignored;
    if (!is_linked && reason != EEXIST && !fs::exists(path, ignored)) {
        fs::rename(made, path, ignored); // On file systems without links.
        if (!ignored)
            return {};
    }
    fs::remove(made, ignored);
    if (is_linked)
        return {};
    return fail(Fault::User,
                reason == EEXIST
                    ? fmt::format("{} is already there: choose another name, a session is never "
                                  "written over",
                                  path.string())
                    : fmt::format("cannot write {}: {}", path.string(), std::strerror(reason)));
}

// The journal is kept beside the file, and synced at each commit.
Result<Database> open_to_write(fs::path const& path)
{
    auto database = TRY(Database::open(path, Database::Access::Write));
    TRY(database.execute("PRAGMA synchronous = FULL"));
    TRY(database.execute("BEGIN IMMEDIATE")); // From here on no other program writes.
    return database;
}

} // namespace

SessionOptions session_by_the_clock(MakeLoadOptions load_options)
{
    return { std::move(load_options), [] {
                return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
            } };
}

Result<Session> Session::create(fs::path const& path, SessionOrigin const& origin,
                                std::span<Edit const> edits, SessionOptions options)
{
    CHECK(!edits.empty());
    SessionContents contents { .origin = origin };
    for (auto const& edit : edits)
        contents.edits.push_back({ 0, edit, origin.created });
    auto history = TRY(SessionHistory::create(std::move(contents), options.load_options));
    std::error_code ignored;
    if (fs::exists(path, ignored))
        return fail(Fault::User,
                    fmt::format("{} is already there: choose another name, a session is never "
                                "written over",
                                path.string()));
    auto const made = fs::path(fmt::format("{}.{}.part", path.string(), ::getpid()));
    auto const write = [&]() -> Result<void> {
        auto const database = TRY(Database::open(made, Database::Access::Create));
        TRY(write_beginning(database, origin, edits));
        return database.execute("PRAGMA journal_mode = WAL");
    };
    if (auto const written = write(); !written) {
        fs::remove(made, ignored);
        return fail(
            Fault::User,
            fmt::format("cannot begin the session {}: {}", path.string(), written.error().message));
    }
    TRY(appear(made, path));
    auto database = TRY(open_to_write(path));
    return Session(path, std::move(database), std::move(options), std::move(history));
}

Result<Session> Session::open(fs::path const& path, SessionOptions options)
{
    auto database = TRY(open_to_write(path));
    TRY(migrate(database, path));
    TRY(database.execute("COMMIT; BEGIN IMMEDIATE"));
    auto contents = TRY(read_session(database, path.string()));
    auto history = SessionHistory::create(std::move(contents), options.load_options);
    if (!history)
        return fail(history.error().fault,
                    fmt::format("{}: {}", path.string(), history.error().message));
    return Session(path, std::move(database), std::move(options), *std::move(history));
}

Session::Session(fs::path path, Database database, SessionOptions options, SessionHistory history)
    : path_(std::move(path))
    , database_(std::move(database))
    , options_(std::move(options))
    , history_(std::move(history))
{
}

Result<void> Session::append(std::span<Edit const> edits)
{
    if (edits.empty())
        return {};
    auto scene = TRY(history_.after(edits));
    SessionStep const step { history_.step() + 1, edits, options_.now() };
    TRY(commit([&] { return write_step(database_, step); }));
    history_.push(step, std::move(scene));
    return {};
}

Result<void> Session::undo()
{
    if (!can_undo())
        return fail(Fault::User, "there is nothing to undo: this is how the session began");
    return go_to(history_.step() - 1);
}

Result<void> Session::redo()
{
    if (!can_redo())
        return fail(Fault::User, "there is nothing to redo: the last step was made, not undone");
    return go_to(history_.step() + 1);
}

Result<void> Session::go_to(std::size_t step)
{
    auto scene = TRY(history_.at(step));
    TRY(commit([&] { return write_cursor(database_, step); }));
    history_.go_to(step, std::move(scene));
    return {};
}

Result<void> Session::commit(std::function<Result<void>()> const& write)
{
    if (!database_.is_in_transaction()) // An error has ended it.
        TRY(database_.execute("BEGIN IMMEDIATE"));
    auto done = write();
    if (done)
        done = database_.execute("COMMIT");
    if (!done && database_.is_in_transaction())
        (void)database_.execute("ROLLBACK");
    // If it cannot be begun now, the next commit tries again.
    (void)database_.execute("BEGIN IMMEDIATE");
    return done;
}

} // namespace tractus
