#pragma once

#include "app/session/database.h"
#include "app/session/edit_record.h"
#include "engine/base/result.h"
#include "engine/scene/edit.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tractus::session {

// A session's file (.tractus): SQLite 3 with these tables and nothing else (session_schema.h), to
// be looked at with its shell.
//
//   edits  number   1, 2, …: the edits in the order in which they were made
//          step     what undo takes back at once; 0: what the session began with
//          kind, fields, numbers  an EditRecord; of any kind, since other programs may know more
//          made     when, in Unix seconds; 0 where nobody knows
//          checksum CRC-32 of what stands before, so that damage does not pass for a drawing
//   meta   key, value: "plant", "program", "created" (Unix seconds), "step", the last that counts:
//          later ones are undone; "name", if a person gave it one; and "language", the
//          kLanguageVersion by which its models were read last, where that is not 1.
//   copies, meta_copies  the same once more, for repair: one damage seldom hits both. Edits of more
//          than 16 MiB have no copy. Each value of meta_copies has the CRC-32 of its key and
//          itself. Rows of copies whose numbers are below 1 only take room.
//
// The file's application_id is "TRAC", its user_version the format's version: 1 had neither made
// nor checksum, 2 no edit of the kind "erase_tips", 3 named strokes and indicators by their numbers
// in a list and selected branches by their segments, and strokes had no tilt; 4 had no copies, and
// the names of files that plants came from had their folders.
constexpr std::int64_t kSessionFormat = 5;

// Where a session comes from.
struct SessionOrigin {
    std::string plant {};                // The name of the model that it began with.
    std::string name {};                 // What a person calls it; may be empty.
    std::string program {};              // The version of tractus that began it.
    std::chrono::sys_seconds created {}; // Time by the clock on the wall.
    int language = 1;                    // The kLanguageVersion of what drew in it last.
};

// Identifies an edit in its file, so that it is found again and known to be the same.
struct EditPlace {
    std::int64_t number = 0;
    std::int64_t checksum = 0;
};

struct SessionEdit {
    std::size_t step = 0; // Step number; edits of one step stand together, and no step is without.
    scene::Edit edit;
    std::chrono::sys_seconds made {}; // Time by the clock on the wall; 0 where nobody knows.
    EditPlace place {};
};

// Edits by another tractus, a newer one or one with more methods, that this program does not know
// (UnknownEdit). Each stays in the file as it is, and what belongs to the same step changes
// nothing, either.
struct UnknownEdits {
    std::size_t count = 0;
    std::string first {}; // "edit 4: its kind …".

    void add(SessionEdit const& edit);

    // A sentence that says so without the file's name; empty where all is known.
    std::string sentence() const;
};

// Everything that a session's file holds.
struct SessionContents {
    SessionOrigin origin {};
    std::vector<SessionEdit> edits {}; // At least one.
    std::size_t step = 0;              // The last that counts.

    std::size_t last_step() const { return edits.back().step; }
};

// The contents without the edits, of which there may be very many.
struct SessionSummary {
    SessionOrigin origin {};
    std::size_t step = 0; // The last that counts.
    std::size_t last_step = 0;
    UnknownEdits unknown {};
};

// Reads a session and changes nothing; another program may be drawing in it. What is none of
// `kinds` is unknown. Fails, as the user's fault, in a sentence, for what is no session, is
// damaged, or is newer than this program. Fails like open_session(), too.
Result<SessionContents> read_session(std::filesystem::path const& path, scene::EditKinds kinds);

// Checks a database that is open, of which `name` is the file's: all edits are checked, and
// forgotten. Fails like read_session().
Result<SessionSummary> check_session(Database const& database, std::string const& name,
                                     scene::EditKinds kinds);

// Edits that belong together.
struct SessionStep {
    std::size_t number = 0;
    std::span<scene::Edit const> edits;
    std::chrono::sys_seconds made {};
};

// An edit as a row of its table.
struct EditRow {
    EditPlace place;
    std::size_t step = 0;
    EditRecord record;
    std::chrono::sys_seconds made {};
};

// Writes rows as a session of their own, which appears whole; `step` is the last that counts.
// Fails, as the user's fault, if the file is there already or cannot be written.
Result<void> write_new_session(std::filesystem::path const& path, SessionOrigin const& origin,
                               std::span<EditRow const> rows, std::size_t step);

// Returns what a row's checksum is if it is as it was written.
std::int64_t checksum_of(EditRow const& row);

// The same of a row of meta_copies; a whole number as its decimal digits.
std::int64_t checksum_of_meta(std::string const& key, std::string const& value);

// The rows that a session begins with: step 0.
std::vector<EditRow> beginning_rows(std::span<scene::Edit const> edits,
                                    std::chrono::sys_seconds made);

// The rows of a step, numbered after all of earlier steps. Fails as the database does, as the
// following do.
Result<std::vector<EditRow>> rows_of(Database const& database, SessionStep const& step);

// Puts a step, which has rows, in the place of all from its number on; it becomes the last that
// counts. Inside of a transaction.
Result<void> write_step(Database const& database, std::span<EditRow const> rows);

// The edits of a step, read back; of a file that was checked. Fails where it was damaged since.
Result<std::vector<SessionEdit>> read_step(Database const& database, std::size_t step,
                                           scene::EditKinds kinds);

// One edit, likewise. Fails, too, where another has taken its place.
Result<scene::Edit> read_edit(Database const& database, EditPlace const& place,
                              scene::EditKinds kinds);

// Brings a session of an older format up to date. The file as it was stays beside it, with ".bak"
// after its name. Nothing happens to a file that is up to date. Inside of a transaction.
Result<void> migrate(Database const& database, std::filesystem::path const& path);

// The kLanguageVersion by which the models are read from now on: this program's. Inside of a
// transaction.
Result<void> write_language(Database const& database);

// What a person calls it; empty: nothing. Inside of a transaction.
Result<void> write_name(Database const& database, std::string const& name);

// The last step that counts. Inside of a transaction.
Result<void> write_cursor(Database const& database, std::size_t step);

} // namespace tractus::session
