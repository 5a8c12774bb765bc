#pragma once

#include "app/session/session_file.h"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::session {

// What could be read from the file of a session although the file's structure is damaged.
struct ScannedSession {
    // Rows with a valid checksum, in ascending order of number, without duplicates.
    std::vector<EditRow> rows;
    // The number of the last row in `rows`; 0 if there is none.
    std::int64_t last_number = 0;
    // Values of "plant", "name", "program", "created" and "step" from the meta table, as text. Keys
    // that were not found are missing.
    std::map<std::string, std::string> meta;
};

// Searches every byte of every page of an SQLite file and of its write-ahead log ("" if there is
// none) for rows of a session. Does not rely on the header, the schema or interior pages of the
// B-trees (The SQLite database file format, sqlite.org/fileformat2.html, sections 1.6, 2.1 and 4).
// If several rows have the same number, a row that its page still lists is preferred, then the row
// made last. Deleted rows are left out, because they belong to steps that were undone and replaced.
//
// No size, count or page number in the file is trusted.
//
// A row of the oldest format, which has no checksum, is accepted if it is a valid edit of one of
// `kinds`.
ScannedSession scan_pages(std::string_view file, std::string_view log, scene::EditKinds kinds);

} // namespace tractus::session
