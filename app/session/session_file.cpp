#include "app/session/session_file.h"

#include "app/session/edit_record.h"

#include <fmt/core.h>
#include <optional>
#include <zlib.h>

namespace tractus {

namespace {

constexpr std::int64_t kApplicationId = 0x54524143; // "TRAC"

tl::unexpected<Error> damaged(std::string const& name, std::string const& what)
{
    return fail(Fault::User,
                fmt::format("{} is damaged ({}): take a copy of it that is not", name, what));
}

// The format's version, one that this program knows.
Result<std::int64_t> read_format(Database const& database, std::string const& name)
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
    return format;
}

std::int64_t checksum(std::size_t step, EditRecord const& record)
{
    auto sum = crc32(0, nullptr, 0);
    for (auto const& part : { std::to_string(step), record.kind, record.fields, record.numbers }) {
        // With its end, so that nothing can go over from one part to the next.
        auto const* const bytes = reinterpret_cast<Bytef const*>(part.c_str());
        sum = crc32_z(sum, bytes, part.size() + 1);
    }
    return static_cast<std::int64_t>(sum);
}

// One row of the edits, with its checksum if the format has one.
struct EditRow {
    std::int64_t number = 0;
    std::size_t step = 0;
    EditRecord record;
    std::chrono::sys_seconds made {};
    std::optional<std::int64_t> sum;
};

Result<std::vector<EditRow>> read_rows(Database const& database, std::int64_t format)
{
    auto rows = TRY(database.prepare(
        format == 1 ? "SELECT number, step, kind, fields, numbers FROM edits ORDER BY number"
                    : "SELECT number, step, kind, fields, numbers, made, checksum FROM edits "
                      "ORDER BY number"));
    std::vector<EditRow> result;
    while (TRY(rows.step())) {
        auto& row = result.emplace_back();
        row.number = rows.whole(0);
        row.step = static_cast<std::size_t>(rows.whole(1));
        row.record = { rows.bytes(2), rows.bytes(3), rows.bytes(4) };
        if (format == 1)
            continue;
        row.made = std::chrono::sys_seconds(std::chrono::seconds(rows.whole(5)));
        row.sum = rows.whole(6);
    }
    return result;
}

Result<void> read_edits(Database const& database, std::string const& name,
                        std::vector<SessionEdit>& edits)
{
    auto const format = TRY(read_format(database, name));
    for (auto& row : TRY(read_rows(database, format))) {
        auto const expected = edits.size() + 1;
        bool const goes_on = edits.empty()
            ? row.step == 0
            : row.step == edits.back().step || row.step == edits.back().step + 1;
        if (row.number != static_cast<std::int64_t>(expected) || !goes_on)
            return damaged(name, fmt::format("edit {} is missing", expected));
        if (row.sum && *row.sum != checksum(row.step, row.record))
            return damaged(name, fmt::format("edit {} is not as it was written", expected));
        auto edit = edit_of(row.record);
        if (!edit)
            return fail(Fault::User,
                        fmt::format("{}: edit {} cannot be read: {}", name, row.number,
                                    edit.error().message));
        edits.push_back({ row.step, *std::move(edit), row.made });
    }
    if (edits.empty())
        return damaged(name, "edit 1 is missing");
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
    SessionContents contents;
    TRY(read_edits(database, name, contents.edits));
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
                         "kind TEXT NOT NULL, fields TEXT NOT NULL, numbers BLOB NOT NULL, "
                         "made INTEGER NOT NULL, checksum INTEGER NOT NULL);"));
    TRY(write_meta(database, "plant", origin.plant));
    TRY(write_meta(database, "program", origin.program));
    TRY(write_meta(database, "created", origin.created.time_since_epoch().count()));
    TRY(write_step(database, { 0, edits, origin.created }));
    return database.execute("COMMIT");
}

Result<void> write_step(Database const& database, SessionStep const& step)
{
    auto const number = static_cast<std::int64_t>(step.number);
    auto undone = TRY(database.prepare("DELETE FROM edits WHERE step >= ?"));
    TRY(undone.bind(0, number).run());
    for (auto const& edit : step.edits) {
        auto const record = record_of(edit);
        auto row = TRY(database.prepare(
            "INSERT INTO edits (number, step, kind, fields, numbers, made, checksum) "
            "SELECT coalesce(max(number), 0) + 1, ?, ?, ?, ?, ?, ? FROM edits"));
        TRY(row.bind(0, number)
                .bind_text(1, record.kind)
                .bind_text(2, record.fields)
                .bind_blob(3, record.numbers)
                .bind(4, step.made.time_since_epoch().count())
                .bind(5, checksum(step.number, record))
                .run());
    }
    return write_cursor(database, step.number);
}

Result<void> migrate(Database const& database, std::filesystem::path const& path)
{
    if (TRY(read_format(database, path.string())) == kSessionFormat)
        return {};
    // By another connection, since one that may write cannot be copied from.
    auto const as_it_was = TRY(Database::open(path, Database::Access::Read));
    TRY(as_it_was.back_up(path.string() + ".bak"));
    TRY(database.execute("ALTER TABLE edits ADD COLUMN made INTEGER NOT NULL DEFAULT 0;"
                         "ALTER TABLE edits ADD COLUMN checksum INTEGER NOT NULL DEFAULT 0;"));
    auto update = TRY(database.prepare("UPDATE edits SET checksum = ? WHERE number = ?"));
    for (auto const& row : TRY(read_rows(database, 1)))
        TRY(update.bind(0, checksum(row.step, row.record)).bind(1, row.number).run());
    return database.execute(fmt::format("PRAGMA user_version = {}", kSessionFormat));
}

Result<void> write_cursor(Database const& database, std::size_t step)
{
    return write_meta(database, "step", static_cast<std::int64_t>(step));
}

} // namespace tractus
