#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::session {

// An edit as a session stores it: the same bytes on every machine, and every number exact.
struct EditRecord {
    std::string kind;   // "load_model", "select", …
    std::string fields; // JSON object with the edit's fields.

    // Numbers too many for JSON, concatenated in little-endian order, with IEEE 754 floats. For a
    // stroke, each tip: its time in nanoseconds as int64; x, y, z and pressure as float64; a byte
    // of flags (1 touching, 2 eraser, 4 height extrapolated, 8 outside the calibration, 16 tilted);
    // and, if tilted, the tilt towards x and y as float64. For a skeleton, each line: x, y and z of
    // both ends as float64. For a picture, its file unchanged. Empty for other edits.
    std::string numbers;
};

// Converts an edit to a record. File paths are shortened to names, because sessions and recordings
// are shared with other people, and folder names are private. Numbers that are not finite become
// strings of 16 hexadecimal digits, their bits. A string that is not UTF-8, as file names may be,
// becomes {"bytes": "…"} with a character from U+0000 to U+00FF for each byte.
EditRecord record_of(scene::Edit const& edit);

// Returns the record with its file paths shortened to names; older programs stored whole paths.
EditRecord without_folders(EditRecord record);

// Converts a record to an edit. Fails, in a sentence without the file's name, for a kind that is
// not among `kinds`, an unknown field, or a value of the wrong form. Missing fields keep their
// defaults, since older programs did not write them.
Result<scene::Edit> edit_of(EditRecord const& record, scene::EditKinds kinds);

// Like edit_of(), except that a refused record becomes an UnknownEdit: the session may come from a
// newer program, or from one with more methods.
scene::Edit edit_or_unknown(EditRecord const& record, scene::EditKinds kinds);

} // namespace tractus::session
