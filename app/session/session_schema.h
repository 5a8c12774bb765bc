#pragma once

#include "app/session/database.h"
#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace tractus::session {

// The tables of a session's file (session_file.h). A file may come from an untrusted source, so its
// schema is checked against those that tractus writes before anything else is read or written.

// Opens an existing file. Fails with a user error that names the file, like
// Database::open(); if it is not a session or has a newer format; and if its schema has anything
// besides a session's tables, such as a view, a trigger, an index or an extra column.
Result<Database> open_session(std::filesystem::path const& path, Database::Access access);

// Reads the version of the file's format. Fails like open_session() if this program does not know
// it; `name` is the file's name.
Result<std::int64_t> read_format(Database const& database, std::string const& name);

// Creates the tables of the current format in an empty database. Call inside a transaction.
Result<void> make_tables(Database const& database);

// Updates the tables of an older format; tables that are new stay empty. Call inside a transaction.
Result<void> update_tables(Database const& database, std::int64_t format);

// The error sentence for a damaged file.
tl::unexpected<Error> damaged(std::string const& name, std::string const& what);

} // namespace tractus::session
