#pragma once

#include "app/session/session_file.h"
#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::session {

// What could be read of a session that may be damaged anywhere.
struct SalvagedSession {
    scene::EditKinds kinds {}; // Kinds of edits that the program knows.
    SessionOrigin origin {};
    std::vector<EditRow> rows {};         // Intact rows in order; at least one.
    std::vector<std::int64_t> missing {}; // Numbers of lost edits among the intact ones.
    std::optional<std::size_t> step {};   // The current step; nullopt if it was lost.

    // Number of steps that lost some of their edits but not all.
    std::size_t broken_steps = 0;
};

// Reads every intact edit of a session, wherever it is in the file, even if SQLite calls the file
// malformed; changes nothing. Fails with a user error if there is none, or if the file cannot
// be read or is larger than 4 GiB.
Result<SalvagedSession> salvage_session(std::filesystem::path const& path, scene::EditKinds kinds);

// Makes the contents of a session from the salvaged edits, renumbered without gaps. Edits that this
// program does not know become UnknownEdits.
SessionContents contents_of(SalvagedSession const& session);

// Writes the salvaged edits as a new session, created atomically, after the edits of `beginning`,
// which replace a lost plant. Fails with a user error if the file exists or cannot be written.
Result<void> write_repaired(SalvagedSession const& session,
                            std::vector<scene::Edit> const& beginning,
                            std::filesystem::path const& path);

} // namespace tractus::session
