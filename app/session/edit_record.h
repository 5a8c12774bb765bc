#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::session {

// An edit as a session stores it. The bytes are the same on every machine, and every number is
// exact.
struct EditRecord {
    std::string kind;   // Name of the edit's kind, such as "load_model" or "select".
    std::string fields; // JSON object with the edit's fields.

    // An edit's bulk numbers, too many for JSON: concatenated, in little-endian order, with IEEE
    // 754 floats. For a stroke, each tip has: its time in nanoseconds as int64; x, y, z and
    // pressure as float64; a byte of flags (1 touching, 2 eraser, 4 height extrapolated, 8 outside
    // the calibration, 16 tilted); and, if tilted, the tilt towards x and y as float64. For a
    // skeleton, each line has x, y and z of both ends as float64. For a picture, the bytes of its
    // file. Empty for other edits.
    std::string numbers;
};

// Converts an edit to a record. File paths are shortened to file names, because sessions and
// recordings are shared with other people, and folder names are private. A number that is not
// finite becomes a string with its bits as 16 hexadecimal digits. A string that is not valid UTF-8,
// as file names may be, becomes {"bytes": "…"} with one character from U+0000 to U+00FF per byte.
EditRecord record_of(scene::Edit const& edit);

// Returns the record with its file paths shortened to file names, as older programs stored whole
// paths.
EditRecord without_folders(EditRecord record);

// Converts a record to an edit. Fails for a kind that is not among `kinds`, an unknown field, or a
// value of the wrong form; the message does not name the session's file. Fields that the record
// lacks keep their defaults, since older programs did not write them.
Result<scene::Edit> edit_of(EditRecord const& record, scene::EditKinds kinds);

// Like edit_of(), but a record for which edit_of() fails becomes an UnknownEdit: the session may
// come from a newer program, or from one with more methods.
scene::Edit edit_or_unknown(EditRecord const& record, scene::EditKinds kinds);

} // namespace tractus::session
