#pragma once

#include "app/session/session_file.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::session {

// Contents that can still be read of a session's file whose structure is damaged.
struct ScannedSession {
    // Rows in the order of their numbers, each once; all whose checksum holds.
    std::vector<EditRow> rows;
    // Greatest of the rows and of what is left of others, as far as is known.
    std::int64_t last_number = 0;
    // "plant", "program", "created" and "step" of the meta table, as texts; what is not found is
    // missing.
    std::map<std::string, std::string> meta;
};

// Looks for rows of a session at every byte of every page of a SQLite file and of the write-ahead
// log beside it ("" where there is none), whatever the header, the schema and the trees' interior
// pages say (The SQLite database file format, sqlite.org/fileformat2.html, sections 1.6, 2.1 and
// 4). Where a number is found more than once the row that its page still lists counts, then the one
// that was made last; rows that were deleted, since what they held was undone and something else
// done, stay away.
//
// No size, count or page number that stands in the file is believed.
//
// A row of the oldest format, which has no checksum, is one if it is an edit of these kinds.
ScannedSession scan_pages(std::string_view file, std::string_view log, scene::EditKinds kinds);

} // namespace tractus::session
