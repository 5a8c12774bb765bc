#pragma once

#include "app/session/session_file.h"
#include "engine/base/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::session {

// What could be read of a session's file, any part of which may be damaged.
struct SalvagedSession {
    scene::EditKinds kinds {}; // Kinds of edits that the program knows.
    SessionOrigin origin {};
    std::vector<EditRow> rows {};         // Intact edits in order; at least one.
    std::vector<std::int64_t> missing {}; // Numbers of lost edits before the last intact one.
    std::optional<std::size_t> step {};   // The current step; nullopt if its number was lost.

    // Number of intact steps beside a gap in the edits' numbers; each may have lost some edits.
    std::size_t broken_steps = 0;
};

// Reads every intact edit of a session, wherever in the file it is, even if SQLite calls the file
// malformed. The file is not changed. Fails with a user error if there is no intact edit, or if the
// file cannot be read or is larger than 4 GiB.
Result<SalvagedSession> salvage_session(std::filesystem::path const& path, scene::EditKinds kinds);

// The bytes of a session's file and of the write-ahead log beside it ("" if there is none).
struct SessionBytes {
    std::string_view file {};
    std::string_view log {};
};

// Like the function above, for bytes in memory; `path` is the file's name, for messages and for
// what the session does not say of itself.
Result<SalvagedSession> salvage_session(SessionBytes const& bytes,
                                        std::filesystem::path const& path, scene::EditKinds kinds);

// Makes the contents of a session from the salvaged edits, numbered anew without gaps. Edits that
// this program does not know become UnknownEdits.
SessionContents contents_of(SalvagedSession const& session);

// Writes the edits of `beginning`, which replace a lost plant, and then the salvaged edits as a new
// session's file, created atomically. Fails with a user error if the file exists or cannot be
// written.
Result<void> write_repaired(SalvagedSession const& session,
                            std::vector<scene::Edit> const& beginning,
                            std::filesystem::path const& path);

} // namespace tractus::session
