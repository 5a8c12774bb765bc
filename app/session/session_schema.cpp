#include "app/session/session_schema.h"

#include "app/session/session_file.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <set>
#include <string_view>

namespace tractus::session {

namespace {

constexpr std::int64_t kApplicationId = 0x54524143; // "TRAC" in ASCII.
constexpr std::int64_t kFirstWithCopies = 5; // First format with the tables copies and meta_copies.

constexpr std::string_view kMeta = "CREATE TABLE meta (key TEXT PRIMARY KEY, value)";
constexpr std::string_view kEdits
    = "CREATE TABLE edits (number INTEGER PRIMARY KEY, step INTEGER NOT NULL, kind TEXT NOT NULL, "
      "fields TEXT NOT NULL, numbers BLOB NOT NULL, made INTEGER NOT NULL, checksum INTEGER NOT "
      "NULL)";
constexpr std::string_view kEditsOfFormat1
    = "CREATE TABLE edits (number INTEGER PRIMARY KEY, step INTEGER NOT NULL, kind TEXT NOT NULL, "
      "fields TEXT NOT NULL, numbers BLOB NOT NULL)";
// SQL of the table "edits" in files that were created in format 1 and have been updated since.
constexpr std::string_view kUpdatedEdits
    = "CREATE TABLE edits (number INTEGER PRIMARY KEY, step INTEGER NOT NULL, kind TEXT NOT NULL, "
      "fields TEXT NOT NULL, numbers BLOB NOT NULL, made INTEGER NOT NULL DEFAULT 0, checksum "
      "INTEGER NOT NULL DEFAULT 0)";
constexpr std::string_view kMetaCopies
    = "CREATE TABLE meta_copies (key TEXT PRIMARY KEY, value, checksum INTEGER NOT NULL)";
constexpr std::string_view kCopies
    = "CREATE TABLE copies (number INTEGER PRIMARY KEY, step INTEGER NOT NULL, kind TEXT NOT NULL, "
      "fields TEXT NOT NULL, numbers BLOB NOT NULL, made INTEGER NOT NULL, checksum INTEGER NOT "
      "NULL)";

// A row that SQLite's table sqlite_schema may have in a session's file.
struct SchemaRow {
    std::string_view type;
    std::string_view name;
    std::string_view table;
    std::string_view sql;
};

constexpr std::array kAllowed {
    SchemaRow { "table", "meta", "meta", kMeta },
    SchemaRow { "index", "sqlite_autoindex_meta_1", "meta", "" },
    SchemaRow { "table", "edits", "edits", kEdits },
    SchemaRow { "table", "edits", "edits", kEditsOfFormat1 },
    SchemaRow { "table", "edits", "edits", kUpdatedEdits },
    SchemaRow { "table", "meta_copies", "meta_copies", kMetaCopies },
    SchemaRow { "index", "sqlite_autoindex_meta_copies_1", "meta_copies", "" },
    SchemaRow { "table", "copies", "copies", kCopies },
};

bool is_allowed(std::array<std::string, 4> const& row)
{
    return std::any_of(kAllowed.begin(), kAllowed.end(), [&](SchemaRow const& allowed) {
        return row[0] == allowed.type && row[1] == allowed.name && row[2] == allowed.table
            && row[3] == allowed.sql;
    });
}

tl::unexpected<Error> not_ours(std::string const& name, std::string const& what)
{
    return fail(Fault::User,
                fmt::format("{} is not as tractus writes sessions: it has {}; \"tractus session "
                            "repair {} -o NEW.tractus\" brings back the edits in it",
                            name, what, name));
}

// Checks that the database has a session's tables and nothing else. No two tables may share a root
// page, because they would overwrite each other.
Result<void> check_schema(Database const& database, std::string const& name, std::int64_t format)
{
    auto rows = TRY(database.prepare(
        "SELECT type, name, tbl_name, coalesce(sql, ''), rootpage FROM sqlite_schema"));
    std::set<std::string> found;
    std::set<std::int64_t> places { 0, 1 };
    while (TRY(rows.step())) {
        std::array const row { rows.bytes(0), rows.bytes(1), rows.bytes(2), rows.bytes(3) };
        if (!is_allowed(row) || !found.insert(row[1]).second)
            return not_ours(name, fmt::format("a {} \"{}\"", row[0], row[1]));
        if (!places.insert(rows.whole(4)).second)
            return damaged(name, "its tables overlap");
    }
    std::set<std::string> wanted { "meta", "edits" };
    if (format >= kFirstWithCopies)
        wanted.insert({ "meta_copies", "copies" });
    for (auto const& table : wanted)
        if (!found.contains(table))
            return damaged(name, fmt::format("it has no table \"{}\"", table));
    return {};
}

// Inserts two large empty rows into the table "copies", so that its rows are on separate leaf pages
// from the first edit on. These pages stay where they are while the table grows, so a truncated
// file still has the copies of all its edits.
Result<void> reserve_leaves(Database const& database)
{
    return database.execute("INSERT INTO copies VALUES (-2, 0, '', '', zeroblob(2200), 0, 0), "
                            "(-1, 0, '', '', zeroblob(2200), 0, 0)");
}

} // namespace

tl::unexpected<Error> damaged(std::string const& name, std::string const& what)
{
    return fail(
        Fault::User,
        fmt::format("{0} is damaged ({1}): \"tractus session repair {0} -o NEW.tractus\" brings "
                    "back what is whole",
                    name, what));
}

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

Result<Database> open_session(std::filesystem::path const& path, Database::Access access)
{
    auto database = TRY(Database::open(path, access));
    TRY(check_is_session(database, path.string()));
    return database;
}

Result<void> check_is_session(Database const& database, std::string const& name)
{
    return check_schema(database, name, TRY(read_format(database, name)));
}

Result<void> make_tables(Database const& database)
{
    TRY(database.execute(fmt::format("PRAGMA application_id = {}", kApplicationId)));
    TRY(database.execute(fmt::format("PRAGMA user_version = {}", kSessionFormat)));
    for (auto const table : { kMeta, kEdits, kMetaCopies, kCopies })
        TRY(database.execute(std::string(table)));
    return reserve_leaves(database);
}

Result<void> update_tables(Database const& database, std::int64_t format)
{
    if (format == 1)
        TRY(database.execute("ALTER TABLE edits ADD COLUMN made INTEGER NOT NULL DEFAULT 0;"
                             "ALTER TABLE edits ADD COLUMN checksum INTEGER NOT NULL DEFAULT 0;"));
    if (format < kFirstWithCopies) {
        TRY(database.execute(std::string(kMetaCopies)));
        TRY(database.execute(std::string(kCopies)));
        TRY(reserve_leaves(database));
    }
    return database.execute(fmt::format("PRAGMA user_version = {}", kSessionFormat));
}

} // namespace tractus::session
