#pragma once

#include "app/session/database.h"
#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace tractus::session {

// The tables of a session's file (session_file.h). A file may come from anybody, so nothing of it
// is read or written before its schema is known to be one that tractus has written.

// Opens a file that is there. Fails, as the user's fault, in a sentence with the file's name: like
// Database::open(), for what is no session, for one of a newer format, and for one that holds
// anything but a session's tables: a view, a trigger, an index, or a column of its own.
Result<Database> open_session(std::filesystem::path const& path, Database::Access access);

// The version of the format, one that this program knows. Fails like open_session(); `name` is the
// file's.
Result<std::int64_t> read_format(Database const& database, std::string const& name);

// Makes the tables of an empty database, of the newest format. Inside of a transaction.
Result<void> make_tables(Database const& database);

// Brings tables of an older format up to date, which lack rows in those that are new. Inside of a
// transaction.
Result<void> update_tables(Database const& database, std::int64_t format);

// The sentence for a damaged file.
tl::unexpected<Error> damaged(std::string const& name, std::string const& what);

} // namespace tractus::session
