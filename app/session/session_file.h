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
//          step     the step of the edit; undo removes one step at a time; 0: the beginning
//          kind, fields, numbers  an EditRecord, of any kind: newer programs may know more
//          made     time in Unix seconds; 0 if unknown
//          checksum CRC-32 of the columns before it, to detect damage
//   meta   key, value: "plant", "program", "created" (Unix seconds); "step", the current step:
//          later ones are undone; "name", if the user gave it one; and "language", the
//          kLanguageVersion with which its models were last read, if that is not 1.
//   copies, meta_copies  duplicates of both tables, for repair. Edits of more than 16 MiB have
//          no copy. Each value of meta_copies has the CRC-32 of its key and itself. Rows of
//          copies with numbers below 1 are padding.
//
// The file's application_id is "TRAC", its user_version the format's version. Version 1 had neither
// made nor checksum; 2 had no edit of the kind "erase_tips"; 3 referred to strokes and indicators
// by their position in a list and to selected branches by their segments, and its strokes had no
// tilt; 4 had no copies and stored whole paths of the plants' files.
constexpr std::int64_t kSessionFormat = 5;

// Origin of a session.
struct SessionOrigin {
    std::string plant {};                // Name of the model with which the session began.
    std::string name {};                 // Name that the user gave the session; may be empty.
    std::string program {};              // Version of tractus that created the session.
    std::chrono::sys_seconds created {}; // Wall-clock time of creation.
    int language = 1;                    // kLanguageVersion of the program that changed it last.
};

// Identifies an edit in a file by its number and checksum, to detect a replaced one.
struct EditPlace {
    std::int64_t number = 0;
    std::int64_t checksum = 0;
};

struct SessionEdit {
    // Number of the edit's step. Steps are contiguous, with at least one edit each.
    std::size_t step = 0;
    scene::Edit edit;
    std::chrono::sys_seconds made {}; // Wall-clock time of the edit; 0 if unknown.
    EditPlace place {};
};

// Edits in a file that this program does not know (UnknownEdit), because a newer tractus, or one
// with more methods, made them. They stay in the file; a step with such an edit has no effect.
struct UnknownEdits {
    std::size_t count = 0;
    std::string first {}; // Describes the first such edit: "edit 4: its kind …".

    void add(SessionEdit const& edit);

    // A sentence for the user about these edits, without the file's name; empty if there are none.
    std::string sentence() const;
};

// The contents of a session's file.
struct SessionContents {
    SessionOrigin origin {};
    std::vector<SessionEdit> edits {}; // All edits in order; at least one.
    std::size_t step = 0;              // The current step; later ones are undone.

    std::size_t last_step() const { return edits.back().step; }
};

// The contents without the edits, of which there may be very many.
struct SessionSummary {
    SessionOrigin origin {};
    std::size_t step = 0; // The current step; later ones are undone.
    std::size_t last_step = 0;
    UnknownEdits unknown {};
};

// Reads a session without changing it; another program may be drawing in it. Edits whose kind is
// not among `kinds` become UnknownEdits. Fails like open_session() and with a user error if the
// file is not a session, is damaged, or is newer than this program.
Result<SessionContents> read_session(std::filesystem::path const& path, scene::EditKinds kinds);

// Checks all edits of an open database without keeping them; `name` is the file's, for messages.
// Fails like read_session().
Result<SessionSummary> check_session(Database const& database, std::string const& name,
                                     scene::EditKinds kinds);

// Edits that undo removes together.
struct SessionStep {
    std::size_t number = 0;
    std::span<scene::Edit const> edits;
    std::chrono::sys_seconds made {};
};

// A row of the table edits.
struct EditRow {
    EditPlace place;
    std::size_t step = 0;
    EditRecord record;
    std::chrono::sys_seconds made {};
};

// Writes rows as a new session, created atomically; `step` is the current step. Fails with a user
// error if the file exists or cannot be written.
Result<void> write_new_session(std::filesystem::path const& path, SessionOrigin const& origin,
                               std::span<EditRow const> rows, std::size_t step);

// Returns the checksum of an intact row.
std::int64_t checksum_of(EditRow const& row);

// Returns the checksum of an intact row of meta_copies; integer values are given in decimal digits.
std::int64_t checksum_of_meta(std::string const& key, std::string const& value);

// The rows of step 0, a session's beginning.
std::vector<EditRow> beginning_rows(std::span<scene::Edit const> edits,
                                    std::chrono::sys_seconds made);

// The rows of a step, numbered after those of all earlier steps. This and the functions below fail
// like the database.
Result<std::vector<EditRow>> rows_of(Database const& database, SessionStep const& step);

// Writes a step's rows, at least one, in place of this and all later steps; it becomes the current
// step. Call inside a transaction.
Result<void> write_step(Database const& database, std::span<EditRow const> rows);

// Reads back the edits of a step from a checked file. Fails if it was damaged since.
Result<std::vector<SessionEdit>> read_step(Database const& database, std::size_t step,
                                           scene::EditKinds kinds);

// Reads back one edit. Fails also if another edit has taken its place.
Result<scene::Edit> read_edit(Database const& database, EditPlace const& place,
                              scene::EditKinds kinds);

// Updates a session of an older format. The original file stays beside it, with ".bak" appended to
// its name. Does nothing if the format is current. Call inside a transaction.
Result<void> migrate(Database const& database, std::filesystem::path const& path);

// Stores this program's kLanguageVersion, with which the models are read from now on. Call inside a
// transaction.
Result<void> write_language(Database const& database);

// Stores the name that the user gave the session; empty removes it. Call inside a transaction.
Result<void> write_name(Database const& database, std::string const& name);

// Stores the number of the current step. Call inside a transaction.
Result<void> write_cursor(Database const& database, std::size_t step);

} // namespace tractus::session
