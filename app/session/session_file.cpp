#include "app/session/session_file.h"

#include "app/session/new_session_file.h"
#include "app/session/session_schema.h"

#include <fmt/core.h>
#include <functional>
#include <initializer_list>
#include <sqlite3.h>
#include <string_view>
#include <utility>
#include <zlib.h>

namespace tractus::session {

namespace fs = std::filesystem;

namespace {

// Maximum size, in bytes, of an edit of which the file has a copy. Plants and strokes are far
// smaller.
constexpr std::size_t kMaxCopied = std::size_t { 16 } << 20;

// CRC-32 of the parts with a zero byte after each, so that moving bytes from one part to the next
// changes the sum.
std::int64_t checksum_of_parts(std::initializer_list<std::string_view> parts)
{
    auto sum = crc32(0, nullptr, 0);
    for (auto const part : parts) {
        sum = crc32_z(sum, reinterpret_cast<Bytef const*>(part.data()), part.size());
        sum = crc32_z(sum, reinterpret_cast<Bytef const*>(""), 1);
    }
    return static_cast<std::int64_t>(sum);
}

std::int64_t checksum(std::size_t step, EditRecord const& record)
{
    return checksum_of_parts({ std::to_string(step), record.kind, record.fields, record.numbers });
}

constexpr char const* kColumns = "number, step, kind, fields, numbers, made, checksum";

// Reads a row of the table "edits", with the columns kColumns. In format 1, the last two columns do
// not exist.
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

// Calls `take` with each row of the table "edits" in order. Fails if a value has an unexpected
// type.
Result<void> for_each_row(Database const& database, std::int64_t format,
                          std::function<Result<void>(EditRow&&)> const& take)
{
    auto const columns = format > 1 ? kColumns : "number, step, kind, fields, numbers";
    auto rows = TRY(
        database.prepare(fmt::format("SELECT {} FROM edits ORDER BY number", columns).c_str()));
    while (TRY(rows.step())) {
        if (!rows.has_types(format > 1 ? "iittbii" : "iittb"))
            return database.error(SQLITE_MISMATCH);
        TRY(take(row_of(rows, format)));
    }
    return {};
}

// The kinds of edits that are known, and a callback that receives each edit.
struct EditReader {
    scene::EditKinds kinds;
    std::function<void(SessionEdit&&)> take;
};

// Reads all edits of the database and returns the number of the last step. Fails if any is damaged
// or missing.
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

// Returns the lowest number of an edit that belongs to the step `step` or a later one; if there is
// no such edit, the last edit's number plus one. Edits with higher numbers never belong to earlier
// steps.
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

Result<void> write_meta(Database const& database, std::string const& key, std::int64_t value)
{
    auto row = TRY(database.prepare("INSERT OR REPLACE INTO meta VALUES (?, ?)"));
    TRY(row.bind_text(0, key).bind(1, value).run());
    auto copy = TRY(database.prepare("INSERT OR REPLACE INTO meta_copies VALUES (?, ?, ?)"));
    return copy.bind_text(0, key)
        .bind(1, value)
        .bind(2, checksum_of_meta(key, std::to_string(value)))
        .run();
}

Result<void> write_meta(Database const& database, std::string const& key, std::string const& value)
{
    auto row = TRY(database.prepare("INSERT OR REPLACE INTO meta VALUES (?, ?)"));
    TRY(row.bind_text(0, key).bind_text(1, value).run());
    auto copy = TRY(database.prepare("INSERT OR REPLACE INTO meta_copies VALUES (?, ?, ?)"));
    return copy.bind_text(0, key).bind_text(1, value).bind(2, checksum_of_meta(key, value)).run();
}

// Inserts rows into the tables "edits" and "copies".
class RowInserter {
public:
    static Result<RowInserter> create(Database const& database)
    {
        return RowInserter(TRY(insertion(database, "edits")), TRY(insertion(database, "copies")));
    }

    Result<void> insert(EditRow const& row)
    {
        TRY(insert(edits_, row));
        return insert_copy(row);
    }

    Result<void> insert_copy(EditRow const& row)
    {
        if (row.record.fields.size() + row.record.numbers.size() > kMaxCopied)
            return {};
        return insert(copies_, row);
    }

private:
    RowInserter(Statement edits, Statement copies)
        : edits_(std::move(edits))
        , copies_(std::move(copies))
    {
    }

    static Result<Statement> insertion(Database const& database, char const* table)
    {
        return database.prepare(
            fmt::format("INSERT INTO {} ({}) VALUES (?, ?, ?, ?, ?, ?, ?)", table, kColumns)
                .c_str());
    }

    static Result<void> insert(Statement& insertion, EditRow const& row)
    {
        return insertion.bind(0, row.place.number)
            .bind(1, static_cast<std::int64_t>(row.step))
            .bind_text(2, row.record.kind)
            .bind_text(3, row.record.fields)
            .bind_blob(4, row.record.numbers)
            .bind(5, row.made.time_since_epoch().count())
            .bind(6, row.place.checksum)
            .run();
    }

    Statement edits_;
    Statement copies_;
};

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

std::int64_t checksum_of_meta(std::string const& key, std::string const& value)
{
    return checksum_of_parts({ key, value });
}

Result<SessionContents> read_session(std::filesystem::path const& path, scene::EditKinds kinds)
{
    auto const database = TRY(open_session(path, Database::Access::Read));
    // Makes all reads see one consistent state, even while another program writes.
    TRY(database.execute("BEGIN"));
    return read_session(database, path.string(), kinds);
}

Result<SessionContents> read_session(Database const& database, std::string const& name,
                                     scene::EditKinds kinds)
{
    SessionContents contents;
    auto const take = [&](SessionEdit&& edit) { contents.edits.push_back(std::move(edit)); };
    auto summary = TRY(read_all(database, name, { kinds, take }));
    contents.origin = std::move(summary.origin);
    contents.step = summary.step;
    return contents;
}

Result<SessionSummary> check_session(Database const& database, std::string const& name,
                                     scene::EditKinds kinds)
{
    return read_all(database, name, { kinds, [](SessionEdit&&) {} });
}

Result<void> write_session(Database const& database, SessionOrigin const& origin,
                           std::span<EditRow const> rows, std::size_t step)
{
    TRY(database.execute("BEGIN"));
    TRY(make_tables(database));
    TRY(fill_tables(database, origin, rows, step));
    return database.execute("COMMIT");
}

Result<void> fill_tables(Database const& database, SessionOrigin const& origin,
                         std::span<EditRow const> rows, std::size_t step)
{
    TRY(write_meta(database, "plant", origin.plant));
    if (!origin.name.empty())
        TRY(write_name(database, origin.name));
    TRY(write_meta(database, "program", origin.program));
    TRY(write_meta(database, "created", origin.created.time_since_epoch().count()));
    TRY(write_language(database));
    TRY(write_step(database, rows));
    return write_cursor(database, step);
}

Result<void> write_new_session(fs::path const& path, SessionOrigin const& origin,
                               std::span<EditRow const> rows, std::size_t step)
{
    return make_session_file(path, [&](fs::path const& made) -> Result<void> {
        auto const database = TRY(Database::open(made, Database::Access::Create));
        TRY(write_session(database, origin, rows, step));
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
    for (auto const* const table : { "edits", "copies" }) {
        auto undone
            = TRY(database.prepare(fmt::format("DELETE FROM {} WHERE number >= ?", table).c_str()));
        TRY(undone.bind(0, rows.front().place.number).run());
    }
    auto inserter = TRY(RowInserter::create(database));
    for (auto const& row : rows)
        TRY(inserter.insert(row));
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

// Updates the rows of an older format: adds checksums, which format 1 lacked. Adds copies of edits
// and removes folders from file names, both new in format 5. Damaged rows are left unchanged.
static Result<void> update_rows(Database const& database, std::int64_t format)
{
    auto update
        = TRY(database.prepare("UPDATE edits SET fields = ?, checksum = ? WHERE number = ?"));
    auto inserter = TRY(RowInserter::create(database));
    auto const bring_up_to_date = [&](EditRow&& row) -> Result<void> {
        if (format > 1 && row.place.checksum != checksum_of(row))
            return {};
        row.record = without_folders(row.record);
        row.place.checksum = checksum_of(row);
        TRY(update.bind_text(0, row.record.fields)
                .bind(1, row.place.checksum)
                .bind(2, row.place.number)
                .run());
        return inserter.insert_copy(row);
    };
    return for_each_row(database, kSessionFormat, bring_up_to_date);
}

// Writes the contents of the table meta to meta_copies. The values are integers or text.
static Result<void> copy_meta(Database const& database)
{
    auto rows = TRY(database.prepare("SELECT key, value FROM meta"));
    std::vector<std::pair<std::string, std::string>> texts;
    std::vector<std::pair<std::string, std::int64_t>> wholes;
    while (TRY(rows.step())) {
        if (rows.has_types("ti"))
            wholes.emplace_back(rows.bytes(0), rows.whole(1));
        else
            texts.emplace_back(rows.bytes(0), rows.bytes(1));
    }
    for (auto const& [key, value] : texts)
        TRY(write_meta(database, key, value));
    for (auto const& [key, value] : wholes)
        TRY(write_meta(database, key, value));
    return {};
}

Result<void> migrate(Database const& database, std::filesystem::path const& path)
{
    auto const format = TRY(read_format(database, path.string()));
    if (format == kSessionFormat)
        return {};
    // A new connection, because SQLite cannot back up through one that has an open write
    // transaction.
    auto const as_it_was = TRY(open_session(path, Database::Access::Read));
    TRY(as_it_was.back_up(path.string() + ".bak"));
    // Overwrites freed space with zeros, so that the removed folder names leave no trace.
    TRY(database.execute("PRAGMA secure_delete = ON"));
    TRY(update_tables(database, format));
    TRY(update_rows(database, format));
    TRY(copy_meta(database));
    return database.execute("PRAGMA secure_delete = OFF");
}

Result<void> write_language(Database const& database)
{
    return write_meta(database, "language", std::int64_t { lsystem::kLanguageVersion });
}

Result<void> write_name(Database const& database, std::string const& name)
{
    if (name.empty())
        return database.execute("DELETE FROM meta WHERE key = 'name';"
                                "DELETE FROM meta_copies WHERE key = 'name'");
    return write_meta(database, "name", name);
}

Result<void> write_cursor(Database const& database, std::size_t step)
{
    return write_meta(database, "step", static_cast<std::int64_t>(step));
}

} // namespace tractus::session
