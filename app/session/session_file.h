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

// The format of a session's file (.tractus): an SQLite 3 file with these tables and nothing else
// (session_schema.h). It can be inspected with the sqlite3 shell.
//
//   edits  number   1, 2, …: the edits in the order in which they were made
//          step     number of the step that contains the edit; 0: the session's beginning. Undo
//                   removes one step at a time.
//          kind, fields, numbers  the edit's EditRecord. Its kind may be one of a newer program.
//          made     time of the edit in Unix seconds; 0 if unknown
//          checksum CRC-32 of step, kind, fields and numbers, to detect damage
//   meta   key, value: "plant"; "program"; "created" (Unix seconds); "step", the current step:
//          later steps are undone; "name", if the user gave the session a name; and "language",
//          the kLanguageVersion with which the session's models were last read (missing: 1).
//   copies, meta_copies  duplicates of the tables edits and meta, for repair. Edits of more than
//          16 MiB have no copy. Each row of meta_copies also has the CRC-32 of its key and value.
//          Rows of copies with numbers below 1 are padding.
//
// The file's application_id is "TRAC"; its user_version is the version of the format. Version 1 had
// neither made nor checksum. Version 2 had no edit of the kind "erase_tips". Version 3 referred to
// strokes and indicators by their position in a list and to selected branches by their segments,
// and its strokes had no tilt. Version 4 had no copies, and stored whole paths of the plants'
// files.
constexpr std::int64_t kSessionFormat = 5;

// Where a session comes from.
struct SessionOrigin {
    std::string plant {};                // Name of the model with which the session began.
    std::string name {};                 // Name that the user gave the session; may be empty.
    std::string program {};              // Version of tractus that created the session.
    std::chrono::sys_seconds created {}; // Wall-clock time of creation.
    int language = 1; // kLanguageVersion of the last program that changed the session.
};

// Identifies an edit in a file by its number and checksum. The checksum shows whether another edit
// has replaced it.
struct EditPlace {
    std::int64_t number = 0;
    std::int64_t checksum = 0;
};

struct SessionEdit {
    // Number of the step that contains the edit. Step numbers have no gaps; each step has at least
    // one edit.
    std::size_t step = 0;
    scene::Edit edit;
    std::chrono::sys_seconds made {}; // Wall-clock time of the edit; 0 if unknown.
    EditPlace place {};
};

// Edits in a file that this program does not know (UnknownEdit), because a newer tractus made them,
// or one with more methods. They stay in the file; a step with such an edit has no effect.
struct UnknownEdits {
    std::size_t count = 0;
    std::string first {}; // Describes the first unknown edit: "edit 4: its kind …".

    void add(SessionEdit const& edit);

    // A sentence for the user about the unknown edits, without the file's name; empty if there are
    // none.
    std::string sentence() const;
};

// The contents of a session's file.
struct SessionContents {
    SessionOrigin origin {};
    std::vector<SessionEdit> edits {}; // All edits in order; at least one.
    std::size_t step = 0;              // The current step; later steps are undone.

    std::size_t last_step() const { return edits.back().step; }
};

// The contents of a session's file without the edits, of which there may be very many.
struct SessionSummary {
    SessionOrigin origin {};
    std::size_t step = 0; // The current step; later steps are undone.
    std::size_t last_step = 0;
    UnknownEdits unknown {};
};

// Reads a session without changing its file; another program may be drawing in it. Edits whose kind
// is not among `kinds` become UnknownEdits. Fails with a user error if the file cannot be opened,
// is not a session, is damaged, or is newer than this program.
Result<SessionContents> read_session(std::filesystem::path const& path, scene::EditKinds kinds);

// Reads a session from an open database, which was checked by check_is_session(). `name` is the
// file's name, for messages.
Result<SessionContents> read_session(Database const& database, std::string const& name,
                                     scene::EditKinds kinds);

// Checks all edits of an open database without keeping them. `name` is the file's name, for
// messages. Fails with a user error if the file is damaged or newer than this program.
Result<SessionSummary> check_session(Database const& database, std::string const& name,
                                     scene::EditKinds kinds);

// A step: edits that undo removes together.
struct SessionStep {
    std::size_t number = 0;
    std::span<scene::Edit const> edits;
    std::chrono::sys_seconds made {};
};

// A row of the table "edits" in a session's file.
struct EditRow {
    EditPlace place;
    std::size_t step = 0;
    EditRecord record;
    std::chrono::sys_seconds made {};
};

// Writes rows as a new session's file, created atomically. `step` is the current step. Fails with a
// user error if the file exists or cannot be written.
Result<void> write_new_session(std::filesystem::path const& path, SessionOrigin const& origin,
                               std::span<EditRow const> rows, std::size_t step);

// Writes the tables of a new session with its rows into an empty database, in a single transaction.
// Fails with a Database error.
Result<void> write_session(Database const& database, SessionOrigin const& origin,
                           std::span<EditRow const> rows, std::size_t step);

// Writes what a new session contains into its empty tables (make_tables()). Call inside a
// transaction. Fails with a Database error.
Result<void> fill_tables(Database const& database, SessionOrigin const& origin,
                         std::span<EditRow const> rows, std::size_t step);

// Returns the checksum that the row has if it is intact.
std::int64_t checksum_of(EditRow const& row);

// Returns the checksum that a row of meta_copies has if it is intact. `value` is the text or, for
// an integer, its decimal digits.
std::int64_t checksum_of_meta(std::string const& key, std::string const& value);

// Returns the rows for step 0, the beginning of a session.
std::vector<EditRow> beginning_rows(std::span<scene::Edit const> edits,
                                    std::chrono::sys_seconds made);

// Returns the rows for a step, numbered after those of all earlier steps. This function and those
// below fail with a Database error.
Result<std::vector<EditRow>> rows_of(Database const& database, SessionStep const& step);

// Writes the rows of one step, at least one row. They replace the rows of this step and of all
// later steps, and the step becomes the current one. Call inside a transaction.
Result<void> write_step(Database const& database, std::span<EditRow const> rows);

// Reads the edits of a step from a file that was checked. Fails if the file was damaged since the
// check.
Result<std::vector<SessionEdit>> read_step(Database const& database, std::size_t step,
                                           scene::EditKinds kinds);

// Reads a single edit again. Fails also if another edit has replaced it.
Result<scene::Edit> read_edit(Database const& database, EditPlace const& place,
                              scene::EditKinds kinds);

// Updates a session's file of an older format. The original file is kept beside it, with ".bak"
// appended to its name. Does nothing if the format is current. Call inside a transaction.
Result<void> migrate(Database const& database, std::filesystem::path const& path);

// Stores this program's kLanguageVersion in the file, because the session's models are read with it
// from now on. Call inside a transaction.
Result<void> write_language(Database const& database);

// Stores the name that the user gave the session; an empty name removes the old one. Call inside a
// transaction.
Result<void> write_name(Database const& database, std::string const& name);

// Stores the number of the current step. Call inside a transaction.
Result<void> write_cursor(Database const& database, std::size_t step);

} // namespace tractus::session
