#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <ostream>
#include <span>

namespace tractus::exports {

// Writes strokes as lines in one binary glTF 2.0 file: metres, +y up, as our plants are. Each
// stroke is a node and a mesh of its own, "stroke 1" and so on, whose one primitive is a LINE_STRIP
// through its tips; beside the positions it has the attributes _PRESSURE (0 to 1) and _TIME
// (seconds since the stroke's first tip), as floats. When the stroke began, in seconds of the
// recording, is in the node's extras, "begin_s". Same input, same bytes. A stroke without two tips
// is left out, but keeps its number.
//
// `out` must be binary and seekable, as for write_glb(). Fails if the stream fails, if a coordinate
// is not finite, and, before anything is written, if the file would pass glTF's limit of 4 GiB.
Result<void> write_strokes_glb(std::ostream& out, std::span<Stroke const> strokes);

} // namespace tractus::exports
