#include "app/session/session_file.h"

#include "app/session/new_session_file.h"

#include <fmt/core.h>
#include <functional>
#include <utility>
#include <zlib.h>

namespace tractus::session {

namespace fs = std::filesystem;

namespace {

constexpr std::int64_t kApplicationId = 0x54524143; // "TRAC"

tl::unexpected<Error> damaged(std::string const& name, std::string const& what)
{
    return fail(
        Fault::User,
        fmt::format("{0} is damaged ({1}): \"tractus session repair {0} -o NEW.tractus\" brings "
                    "back what is whole",
                    name, what));
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
        // The end is part of it, so that nothing can go over from one part to the next.
        auto const* const bytes = reinterpret_cast<Bytef const*>(part.c_str());
        sum = crc32_z(sum, bytes, part.size() + 1);
    }
    return static_cast<std::int64_t>(sum);
}

constexpr char const* kColumns = "number, step, kind, fields, numbers, made, checksum";

// A row of edits in kColumns' order; those of the first format lack the last two.
EditRow row_of(Statement const& rows, std::int64_t format)
{
    EditRow row;
    row.place.number = rows.whole(0);
    row.step = static_cast<std::size_t>(rows.whole(1));
    row.record = { rows.bytes(2), rows.bytes(3), rows.bytes(4) };
    if (format > 1) {
        row.made = std::chrono::sys_seconds(std::chrono::seconds(rows.whole(5)));
        row.place.checksum = rows.whole(6);
    } else {
        row.place.checksum = checksum(row.step, row.record);
    }
    return row;
}

// Calls `take` with all, in order.
Result<void> for_each_row(Database const& database, std::int64_t format,
                          std::function<Result<void>(EditRow&&)> const& take)
{
    auto const columns = format > 1 ? kColumns : "number, step, kind, fields, numbers";
    auto rows = TRY(
        database.prepare(fmt::format("SELECT {} FROM edits ORDER BY number", columns).c_str()));
    while (TRY(rows.step()))
        TRY(take(row_of(rows, format)));
    return {};
}

// Function that is called with each edit, and the kinds that there are.
struct EditReader {
    scene::EditKinds kinds;
    std::function<void(SessionEdit&&)> take;
};

// Returns the last step.
Result<std::size_t> read_edits(Database const& database, std::string const& name,
                               EditReader const& reader)
{
    auto const format = TRY(read_format(database, name));
    std::int64_t count = 0;
    std::size_t last_step = 0;
    auto const read = [&](EditRow&& row) -> Result<void> {
        ++count;
        bool const goes_on
            = count == 1 ? row.step == 0 : row.step == last_step || row.step == last_step + 1;
        if (row.place.number != count || !goes_on)
            return damaged(name, fmt::format("edit {} is missing", count));
        if (row.place.checksum != checksum(row.step, row.record))
            return damaged(name, fmt::format("edit {} is not as it was written", count));
        last_step = row.step;
        reader.take({ row.step, edit_or_unknown(row.record, reader.kinds), row.made, row.place });
        return {};
    };
    TRY(for_each_row(database, format, read));
    if (count == 0)
        return damaged(name, "edit 1 is missing");
    return last_step;
}

Result<SessionSummary> read_all(Database const& database, std::string const& name,
                                EditReader const& reader)
{
    SessionSummary summary;
    auto const count_unknown = [&](SessionEdit&& edit) {
        summary.unknown.add(edit);
        reader.take(std::move(edit));
    };
    summary.last_step = TRY(read_edits(database, name, { reader.kinds, count_unknown }));
    auto meta = TRY(database.prepare("SELECT key, value FROM meta"));
    std::int64_t step = -1;
    while (TRY(meta.step())) {
        auto const key = meta.bytes(0);
        if (key == "plant")
            summary.origin.plant = meta.bytes(1);
        else if (key == "name")
            summary.origin.name = meta.bytes(1);
        else if (key == "program")
            summary.origin.program = meta.bytes(1);
        else if (key == "created")
            summary.origin.created = std::chrono::sys_seconds(std::chrono::seconds(meta.whole(1)));
        else if (key == "language")
            summary.origin.language = static_cast<int>(meta.whole(1));
        else if (key == "step")
            step = meta.whole(1);
    }
    if (step < 0 || step > static_cast<std::int64_t>(summary.last_step))
        return damaged(name,
                       fmt::format("of its {} steps, step {} should be the last that counts",
                                   summary.last_step, step));
    summary.step = static_cast<std::size_t>(step);
    return summary;
}

// The number of the first edit of this step or a later one; one more than there are if there is
// none. Steps are in the order of their edits' numbers.
Result<std::int64_t> first_number(Database const& database, std::size_t step)
{
    std::int64_t first = 1;
    auto last = TRY(database.whole("SELECT coalesce(max(number), 0) FROM edits")) + 1;
    auto step_of = TRY(database.prepare("SELECT step FROM edits WHERE number = ?"));
    while (first < last) {
        auto const middle = first + (last - first) / 2;
        step_of.bind(0, middle);
        auto const is_there = TRY(step_of.step());
        bool const is_before = is_there && step_of.whole(0) < static_cast<std::int64_t>(step);
        step_of.reset();
        if (is_before)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

tl::unexpected<Error> changed_since(std::int64_t number)
{
    return fail(
        Fault::User,
        fmt::format("edit {} is not in the session's file any more as it was written", number));
}

Result<scene::Edit> checked_edit(EditRow const& row, scene::EditKinds kinds)
{
    if (row.place.checksum != checksum(row.step, row.record))
        return changed_since(row.place.number);
    return edit_or_unknown(row.record, kinds);
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

void UnknownEdits::add(SessionEdit const& edit)
{
    auto const* const unknown = edit.edit.get<scene::UnknownEdit>();
    if (unknown && count++ == 0)
        first = fmt::format("edit {}: {}", edit.place.number, unknown->why);
}

std::string UnknownEdits::sentence() const
{
    if (count == 0)
        return {};
    return fmt::format("{} of its edits {} unknown to this tractus and {} without effect ({}{})",
                       count, count == 1 ? "is" : "are", count == 1 ? "stays" : "stay",
                       count == 1 ? "" : "the first is ", first);
}

std::int64_t checksum_of(EditRow const& row)
{
    return checksum(row.step, row.record);
}

Result<SessionContents> read_session(std::filesystem::path const& path, scene::EditKinds kinds)
{
    auto const database = TRY(Database::open(path, Database::Access::Read));
    TRY(database.execute("BEGIN")); // One moment of it, if another program goes on writing.
    SessionContents contents;
    auto const take = [&](SessionEdit&& edit) { contents.edits.push_back(std::move(edit)); };
    auto summary = TRY(read_all(database, path.string(), { kinds, take }));
    contents.origin = std::move(summary.origin);
    contents.step = summary.step;
    return contents;
}

Result<SessionSummary> check_session(Database const& database, std::string const& name,
                                     scene::EditKinds kinds)
{
    return read_all(database, name, { kinds, [](SessionEdit&&) {} });
}

// The tables, the rows and the origin, in one transaction.
static Result<void> write_tables(Database const& database, SessionOrigin const& origin,
                                 std::span<EditRow const> rows, std::size_t step)
{
    TRY(database.execute("BEGIN"));
    TRY(database.execute(fmt::format("PRAGMA application_id = {}", kApplicationId)));
    TRY(database.execute(fmt::format("PRAGMA user_version = {}", kSessionFormat)));
    TRY(database.execute("CREATE TABLE meta (key TEXT PRIMARY KEY, value);"
                         "CREATE TABLE edits (number INTEGER PRIMARY KEY, step INTEGER NOT NULL, "
                         "kind TEXT NOT NULL, fields TEXT NOT NULL, numbers BLOB NOT NULL, "
                         "made INTEGER NOT NULL, checksum INTEGER NOT NULL);"));
    TRY(write_meta(database, "plant", origin.plant));
    if (!origin.name.empty())
        TRY(write_name(database, origin.name));
    TRY(write_meta(database, "program", origin.program));
    TRY(write_meta(database, "created", origin.created.time_since_epoch().count()));
    TRY(write_language(database));
    TRY(write_step(database, rows));
    TRY(write_cursor(database, step));
    return database.execute("COMMIT");
}

Result<void> write_new_session(fs::path const& path, SessionOrigin const& origin,
                               std::span<EditRow const> rows, std::size_t step)
{
    return make_session_file(path, [&](fs::path const& made) -> Result<void> {
        auto const database = TRY(Database::open(made, Database::Access::Create));
        TRY(write_tables(database, origin, rows, step));
        return database.execute("PRAGMA journal_mode = WAL");
    });
}

std::vector<EditRow> beginning_rows(std::span<scene::Edit const> edits,
                                    std::chrono::sys_seconds made)
{
    std::vector<EditRow> rows;
    for (auto const& edit : edits) {
        auto& row = rows.emplace_back();
        row.record = record_of(edit);
        row.place = { std::ssize(rows), checksum_of(row) };
        row.made = made;
    }
    return rows;
}

Result<std::vector<EditRow>> rows_of(Database const& database, SessionStep const& step)
{
    auto number = TRY(first_number(database, step.number));
    std::vector<EditRow> rows;
    for (auto const& edit : step.edits) {
        auto record = record_of(edit);
        auto const sum = checksum(step.number, record);
        rows.push_back({ { number++, sum }, step.number, std::move(record), step.made });
    }
    return rows;
}

Result<void> write_step(Database const& database, std::span<EditRow const> rows)
{
    auto undone = TRY(database.prepare("DELETE FROM edits WHERE number >= ?"));
    TRY(undone.bind(0, rows.front().place.number).run());
    auto const columns
        = fmt::format("INSERT INTO edits ({}) VALUES (?, ?, ?, ?, ?, ?, ?)", kColumns);
    auto row = TRY(database.prepare(columns.c_str()));
    for (auto const& [place, step, record, made] : rows)
        TRY(row.bind(0, place.number)
                .bind(1, static_cast<std::int64_t>(step))
                .bind_text(2, record.kind)
                .bind_text(3, record.fields)
                .bind_blob(4, record.numbers)
                .bind(5, made.time_since_epoch().count())
                .bind(6, place.checksum)
                .run());
    return write_cursor(database, rows.front().step);
}

Result<std::vector<SessionEdit>> read_step(Database const& database, std::size_t step,
                                           scene::EditKinds kinds)
{
    auto const columns
        = fmt::format("SELECT {} FROM edits WHERE number >= ? ORDER BY number", kColumns);
    auto rows = TRY(database.prepare(columns.c_str()));
    rows.bind(0, TRY(first_number(database, step)));
    std::vector<SessionEdit> edits;
    while (TRY(rows.step())) {
        auto const row = row_of(rows, kSessionFormat);
        if (row.step != step)
            break;
        edits.push_back({ row.step, TRY(checked_edit(row, kinds)), row.made, row.place });
    }
    return edits;
}

Result<scene::Edit> read_edit(Database const& database, EditPlace const& place,
                              scene::EditKinds kinds)
{
    auto const columns = fmt::format("SELECT {} FROM edits WHERE number = ?", kColumns);
    auto rows = TRY(database.prepare(columns.c_str()));
    rows.bind(0, place.number);
    if (!TRY(rows.step()))
        return changed_since(place.number);
    auto const row = row_of(rows, kSessionFormat);
    if (row.place.checksum != place.checksum)
        return changed_since(place.number);
    return checked_edit(row, kinds);
}

// Adds what the first format lacked.
static Result<void> add_checksums(Database const& database)
{
    TRY(database.execute("ALTER TABLE edits ADD COLUMN made INTEGER NOT NULL DEFAULT 0;"
                         "ALTER TABLE edits ADD COLUMN checksum INTEGER NOT NULL DEFAULT 0;"));
    auto update = TRY(database.prepare("UPDATE edits SET checksum = ? WHERE number = ?"));
    auto const add_checksum = [&](EditRow&& row) {
        return update.bind(0, row.place.checksum).bind(1, row.place.number).run();
    };
    return for_each_row(database, 1, add_checksum);
}

Result<void> migrate(Database const& database, std::filesystem::path const& path)
{
    auto const format = TRY(read_format(database, path.string()));
    if (format == kSessionFormat)
        return {};
    // A second connection, since one that may write cannot be copied from.
    auto const as_it_was = TRY(Database::open(path, Database::Access::Read));
    TRY(as_it_was.back_up(path.string() + ".bak"));
    if (format == 1)
        TRY(add_checksums(database));
    return database.execute(fmt::format("PRAGMA user_version = {}", kSessionFormat));
}

Result<void> write_language(Database const& database)
{
    return write_meta(database, "language", std::int64_t { lsystem::kLanguageVersion });
}

Result<void> write_name(Database const& database, std::string const& name)
{
    if (name.empty())
        return database.execute("DELETE FROM meta WHERE key = 'name'");
    return write_meta(database, "name", name);
}

Result<void> write_cursor(Database const& database, std::size_t step)
{
    return write_meta(database, "step", static_cast<std::int64_t>(step));
}

} // namespace tractus::session
