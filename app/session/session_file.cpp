#include "app/session/session_file.h"

#include "app/session/edit_record.h"

#include <fmt/core.h>

namespace tractus {

namespace {

constexpr std::int64_t kApplicationId = 0x54524143; // "TRAC"

tl::unexpected<Error> damaged(std::string const& name, std::string const& what)
{
    return fail(Fault::User,
                fmt::format("{} is damaged ({}): take a copy of it that is not", name, what));
}

Result<void> check_format(Database const& database, std::string const& name)
{
    if (TRY(database.whole("PRAGMA application_id")) != kApplicationId)
        return fail(Fault::User, fmt::format("{} is not a session of tractus", name));
    auto const format = TRY(database.whole("PRAGMA user_version"));
    if (format > kSessionFormat)
        return fail(Fault::User,
                    fmt::format("{} was written by a newer tractus (format {}, and this one knows "
                                "up to {}): open it with that one",
                                name, format, kSessionFormat));
    if (format < 1)
        return damaged(name, fmt::format("its format is {}", format));
    return {};
}

Result<void> read_edits(Database const& database, std::string const& name,
                        std::vector<SessionEdit>& edits)
{
    auto rows = TRY(database.prepare("SELECT number, step, kind, fields, numbers FROM edits "
                                     "ORDER BY number"));
    while (TRY(rows.step())) {
        auto const number = rows.whole(0);
        auto const step = static_cast<std::size_t>(rows.whole(1));
        auto const expected = edits.size() + 1;
        bool const goes_on = edits.empty()
            ? step == 0
            : step == edits.back().step || step == edits.back().step + 1;
        if (number != static_cast<std::int64_t>(expected) || !goes_on)
            return damaged(name, fmt::format("edit {} is missing", expected));
        auto edit = edit_of({ rows.bytes(2), rows.bytes(3), rows.bytes(4) });
        if (!edit)
            return fail(
                Fault::User,
                fmt::format("{}: edit {} cannot be read: {}", name, number, edit.error().message));
        edits.push_back({ step, *std::move(edit) });
    }
    return {};
}

Result<void> write_meta(Database const& database, char const* key, std::int64_t value)
{
    auto row = TRY(database.prepare("INSERT OR REPLACE INTO meta VALUES (?, ?)"));
    return row.bind_text(0, key).bind(1, value).run();
}

Result<void> write_meta(Database const& database, char const* key, std::string const& value)
{
    auto row = TRY(database.prepare("INSERT OR REPLACE INTO meta VALUES (?, ?)"));
    return row.bind_text(0, key).bind_text(1, value).run();
}

} // namespace

Result<SessionContents> read_session(std::filesystem::path const& path)
{
    auto const database = TRY(Database::open(path, Database::Access::Read));
    TRY(database.execute("BEGIN")); // One moment of it, if another program goes on writing.
    return read_session(database, path.string());
}

Result<SessionContents> read_session(Database const& database, std::string const& name)
{
    TRY(check_format(database, name));
    SessionContents contents;
    auto meta = TRY(database.prepare("SELECT key, value FROM meta"));
    std::int64_t step = -1;
    while (TRY(meta.step())) {
        auto const key = meta.bytes(0);
        if (key == "plant")
            contents.origin.plant = meta.bytes(1);
        else if (key == "program")
            contents.origin.program = meta.bytes(1);
        else if (key == "created")
            contents.origin.created = std::chrono::sys_seconds(std::chrono::seconds(meta.whole(1)));
        else if (key == "step")
            step = meta.whole(1);
    }
    TRY(read_edits(database, name, contents.edits));
    if (contents.edits.empty())
        return damaged(name, "edit 1 is missing");
    if (step < 0 || step > static_cast<std::int64_t>(contents.last_step()))
        return damaged(name,
                       fmt::format("of its {} steps, step {} should be the last that counts",
                                   contents.last_step(), step));
    contents.step = static_cast<std::size_t>(step);
    return contents;
}

Result<void> write_beginning(Database const& database, SessionOrigin const& origin,
                             std::span<Edit const> edits)
{
    TRY(database.execute("BEGIN"));
    TRY(database.execute(fmt::format("PRAGMA application_id = {}", kApplicationId)));
    TRY(database.execute(fmt::format("PRAGMA user_version = {}", kSessionFormat)));
    TRY(database.execute("CREATE TABLE meta (key TEXT PRIMARY KEY, value);"
                         "CREATE TABLE edits (number INTEGER PRIMARY KEY, step INTEGER NOT NULL, "
                         "kind TEXT NOT NULL, fields TEXT NOT NULL, numbers BLOB NOT NULL);"));
    TRY(write_meta(database, "plant", origin.plant));
    TRY(write_meta(database, "program", origin.program));
    TRY(write_meta(database, "created", origin.created.time_since_epoch().count()));
    TRY(write_step(database, 0, edits));
    return database.execute("COMMIT");
}

Result<void> write_step(Database const& database, std::size_t step, std::span<Edit const> edits)
{
    auto undone = TRY(database.prepare("DELETE FROM edits WHERE step >= ?"));
    TRY(undone.bind(0, static_cast<std::int64_t>(step)).run());
    for (auto const& edit : edits) {
        auto const record = record_of(edit);
        auto row
            = TRY(database.prepare("INSERT INTO edits (number, step, kind, fields, numbers) "
                                   "SELECT coalesce(max(number), 0) + 1, ?, ?, ?, ? FROM edits"));
        TRY(row.bind(0, static_cast<std::int64_t>(step))
                .bind_text(1, record.kind)
                .bind_text(2, record.fields)
                .bind_blob(3, record.numbers)
                .run());
    }
    return write_cursor(database, step);
}

Result<void> write_cursor(Database const& database, std::size_t step)
{
    return write_meta(database, "step", static_cast<std::int64_t>(step));
}

} // namespace tractus
