#pragma once

#include "app/session/database.h"
#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace tractus::session {

// The tables of a session's file (session_file.h). A file may come from an untrusted source. So its
// schema must equal one that tractus writes; this is checked before anything else is read or
// written.

// Opens an existing file of a session. Fails with a user error that names the file: like
// Database::open(), if the file is not a session or has a newer format, or if its schema has
// anything besides a session's tables, such as a view, a trigger, an index or an extra column.
Result<Database> open_session(std::filesystem::path const& path, Database::Access access);

// Checks an open database as open_session() does. `name` is the file's name, for messages.
Result<void> check_is_session(Database const& database, std::string const& name);

// Reads the version of the file's format. Fails with a user error if the file is not a session or
// this program does not know its format. `name` is the file's name, for messages.
Result<std::int64_t> read_format(Database const& database, std::string const& name);

// Creates the tables of the current format in an empty database, without edits. Call inside a
// transaction.
Result<void> make_tables(Database const& database);

// Changes the tables of an older format to those of the current one; new tables stay without edits.
// Call inside a transaction.
Result<void> update_tables(Database const& database, std::int64_t format);

// The user error for a damaged file; `what` says what is damaged.
tl::unexpected<Error> damaged(std::string const& name, std::string const& what);

} // namespace tractus::session
