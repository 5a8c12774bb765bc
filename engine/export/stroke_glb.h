#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <ostream>
#include <span>

namespace tractus::exports {

// Writes strokes as lines in one binary glTF 2.0 file, in metres, +y up, like our plants. Each
// stroke is a node with a mesh of its own, "stroke 1" and so on, whose only primitive is a
// LINE_STRIP through its tips. In addition to positions it has the attributes _PRESSURE (0 to 1)
// and _TIME (seconds since the stroke's first tip), as floats. The start time of the stroke, in
// seconds of the recording, is in the node's extras, "begin_s". Deterministic. A stroke of fewer
// than two tips is left out, but the others keep their numbers.
//
// `out` must be binary and seekable, as for write_glb(). Fails if the stream fails, a coordinate is
// not finite, or, before anything is written, if the file would exceed glTF's limit of 4 GiB.
Result<void> write_strokes_glb(std::ostream& out, std::span<Stroke const> strokes);

} // namespace tractus::exports
