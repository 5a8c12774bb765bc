// Fuzzes session files in memory. If the first byte is 0, the rest is a file. Otherwise the rest
// lists edits, from which a session with valid checksums is written, in the format that the first
// byte chooses. If nothing follows the list, the session must be read, and salvaged, as it was
// written; otherwise it is damaged at the places that the rest of the input gives.
//
// An edit is its kind, fields and numbers, each ended by a zero byte, and a byte that says whether
// it begins a step; the list ends with an empty kind. A damage is two bytes for its place and one
// that changes the byte there.

#include "app/methods/all_methods.h"
#include "app/session/session_file.h"
#include "app/session/session_repair.h"
#include "app/session/session_schema.h"
#include "tests/fuzz/fuzz_input.h"

#include <algorithm>
#include <fmt/core.h>
#include <string>
#include <vector>

namespace {

using namespace tractus;
using session::Database;

constexpr std::size_t kMaxEdits = 8; // More edits only take longer.

scene::EditKinds kinds()
{
    static auto const all = methods::all_methods().edits;
    return all;
}

std::vector<session::EditRow> take_rows(FuzzInput& input)
{
    std::vector<session::EditRow> rows;
    std::size_t step = 0;
    while (rows.size() < kMaxEdits && !input.text().empty()) {
        auto const kind = input.take_part();
        if (kind.empty())
            break;
        auto& row = rows.emplace_back();
        row.record.kind = kind;
        row.record.fields = input.take_part();
        row.record.numbers = input.take_part();
        step += input.take_byte() % 2 == 1 && rows.size() > 1;
        row.step = step;
        row.place = { std::ssize(rows), session::checksum_of(row) };
    }
    return rows;
}

// An empty session with small pages, so that a file has many of them and is small.
Database empty_session()
{
    auto database = Database::open_in_memory("fuzz").value();
    CHECK(database.execute("PRAGMA page_size = 512; BEGIN"));
    CHECK(session::make_tables(database));
    CHECK(database.execute("COMMIT"));
    return database;
}

// Returns a session's file. `format` is 0 for the newest format. The tables, which are always the
// same, are made only once.
std::string written(std::vector<session::EditRow> const& rows, std::size_t step, unsigned format)
{
    static auto const database = empty_session();
    CHECK(database.execute("BEGIN"));
    CHECK(session::fill_tables(database, { .plant = "fuzz", .program = "1" }, rows, step));
    if (format == 1 || format == 2)
        CHECK(database.execute(fmt::format("DROP TABLE copies; DROP TABLE meta_copies;"
                                           "PRAGMA user_version = {}",
                                           format)));
    if (format == 1)
        CHECK(database.execute("ALTER TABLE edits DROP COLUMN made;"
                               "ALTER TABLE edits DROP COLUMN checksum"));
    auto bytes = database.bytes().value();
    CHECK(database.execute("ROLLBACK"));
    return bytes;
}

Result<session::SessionContents> read_bytes(std::string_view bytes)
{
    auto const database = TRY(Database::open_in_memory("fuzz", bytes));
    TRY(session::check_is_session(database, "fuzz"));
    return session::read_session(database, "fuzz", kinds());
}

void read_and_salvage(std::string_view bytes)
{
    auto const read = read_bytes(bytes);
    if (is_read(read))
        CHECK(!read->edits.empty());
    auto const salvaged = session::salvage_session({ bytes, "" }, "fuzz", kinds());
    if (is_read(salvaged))
        CHECK(!session::contents_of(*salvaged).edits.empty());
}

void check_undamaged(std::string const& bytes, std::vector<session::EditRow> const& rows)
{
    auto const read = read_bytes(bytes);
    CHECK(read);
    CHECK(read->edits.size() == rows.size());
    auto const salvaged = session::salvage_session({ bytes, "" }, "fuzz", kinds());
    CHECK(salvaged);
    CHECK(salvaged->missing.empty());
    CHECK(std::equal(rows.begin(), rows.end(), salvaged->rows.begin(), salvaged->rows.end(),
                     [](session::EditRow const& one, session::EditRow const& other) {
                         return one.place.checksum == other.place.checksum
                             && one.record.fields == other.record.fields
                             && one.record.numbers == other.record.numbers;
                     }));
}

void damage(std::string& bytes, FuzzInput input)
{
    while (!input.text().empty()) {
        auto const low = input.take_byte();
        auto const place = (low + 256 * input.take_byte()) % bytes.size();
        bytes[place] = static_cast<char>(static_cast<unsigned char>(bytes[place])
                                         ^ static_cast<unsigned char>(input.take_byte()));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    FuzzInput input(data, size);
    auto const how = input.take_byte();
    if (how == 0) {
        read_and_salvage(input.text());
        return 0;
    }
    auto const rows = take_rows(input);
    if (rows.empty())
        return 0;
    auto const format = how / 64;
    auto bytes = written(rows, how % (rows.back().step + 1), format);
    if (input.text().empty() && format != 1) {
        check_undamaged(bytes, rows);
    } else {
        damage(bytes, input);
        read_and_salvage(bytes);
    }
    return 0;
}
