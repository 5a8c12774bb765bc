#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <ostream>
#include <span>

namespace tractus::exports {

// Writes strokes as lines in one binary glTF 2.0 file, in metres, +y up, like our plants. Each
// stroke is a node with a mesh of its own, named "stroke 1" and so on. The mesh has one primitive,
// a LINE_STRIP through the stroke's tips, with positions and the attributes _PRESSURE (0 to 1) and
// _TIME (seconds since the stroke's first tip), as floats. The node's extras have the start time of
// the stroke as "begin_s", in seconds of the recording. The same strokes always give the same
// bytes. A stroke of fewer than two tips is left out, but the others keep their numbers.
//
// `out` must be binary and seekable. Fails if the stream fails, a coordinate is not finite, or,
// before anything is written, if the file would exceed glTF's limit of 4 GiB.
Result<void> write_strokes_glb(std::ostream& out, std::span<Stroke const> strokes);

} // namespace tractus::exports
