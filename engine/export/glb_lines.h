#pragma once

#include "engine/base/result.h"
#include "engine/plant/skeleton_lines.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// The lines (primitives of modes LINES, LINE_LOOP and LINE_STRIP) of a binary glTF 2.0 file, with
// all node transforms, taken to our frame (millimetres, +z up): a skeleton for plant_from_lines().
// Triangles and points beside them are left out.
//
// Fails like read_glb(), and for a file without lines, in a sentence with `name` in it. Any bytes
// are safe to give.
Result<std::vector<SkeletonPiece>> read_glb_lines(std::string const& name, std::string_view bytes);

} // namespace tractus::exports
