#pragma once

#include "app/session/session_file.h"
#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::session {

// Remains of a session that may be damaged anywhere.
struct SalvagedSession {
    scene::EditKinds kinds {}; // Kinds that the program knows.
    SessionOrigin origin {};
    std::vector<EditRow> rows {};         // Rows as they were written, in order; at least one.
    std::vector<std::int64_t> missing {}; // The numbers of those that are lost among them.
    std::optional<std::size_t> step {};   // The last that counts; no value where that is lost, too.

    // How many of the steps that have lost an edit have another that is still there.
    std::size_t broken_steps = 0;
};

// Reads every edit of a session that is as it was written, wherever it stands, and changes nothing:
// also where SQLite calls the file malformed. Fails, as the user's fault, where there is none, and
// for a file that cannot be read or is larger than 4 GiB.
Result<SalvagedSession> salvage_session(std::filesystem::path const& path, scene::EditKinds kinds);

// Makes a session's contents of those edits, numbered anew without gaps. Edits that this program
// does not know are UnknownEdits.
SessionContents contents_of(SalvagedSession const& session);

// Writes what was salvaged as a new session, which appears whole. `beginning` comes before it: a
// plant, where that was lost. Fails, as the user's fault, where the file is there already or cannot
// be written.
Result<void> write_repaired(SalvagedSession const& session,
                            std::vector<scene::Edit> const& beginning,
                            std::filesystem::path const& path);

} // namespace tractus::session
