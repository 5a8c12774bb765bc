#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"

#include <string>

namespace tractus::session {

// An edit as a session keeps it: the same bytes on every machine, and every number exactly.
struct EditRecord {
    std::string kind;   // "load_model", "select", …
    std::string fields; // A JSON object: the edit's fields by the names that its kind gives them.

    // Numbers of which there are too many for JSON, one after the other, little-endian,
    // floating-point numbers as IEEE 754 has them. Of a stroke each tip: its time in nanoseconds as
    // int64, x, y, z and pressure as float64, and a byte of flags (1 touching, 2 eraser, 4 height
    // extrapolated, 8 outside the calibration, 16 tilted), and behind that, if it is tilted, the
    // tilt towards x and y as float64. Of a skeleton each line: x, y and z of both ends as float64.
    // Of a picture its file, as it is. Of other edits nothing.
    std::string numbers;
};

// Converts an edit. Of the files that a plant came from it has the names without their folders: a
// session and a recording are given to others, whom the folders do not concern. In the JSON,
// numbers that are not finite are strings of 16 hexadecimal digits: their bits. A string that is no
// UTF-8, as texts and names of files may be, is {"bytes": "…"} with a character U+0000 to U+00FF
// for each byte.
EditRecord record_of(scene::Edit const& edit);

// The record without such folders, as an older program may have written it.
EditRecord without_folders(EditRecord record);

// Refuses, in a sentence without the file's name, a kind that is none of `kinds`, a field that it
// does not have, and what does not have its form. Fields that are missing are as they are by
// default, as they were before a newer program knew them.
Result<scene::Edit> edit_of(EditRecord const& record, scene::EditKinds kinds);

// The edit of a record, or where edit_of() refuses it the record itself, as an UnknownEdit: a
// session may come from a newer program, or from one with more methods.
scene::Edit edit_or_unknown(EditRecord const& record, scene::EditKinds kinds);

} // namespace tractus::session
