#pragma once

#include "engine/base/result.h"
#include "engine/plant/skeleton_lines.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Reads the lines (primitives of modes LINES, LINE_LOOP and LINE_STRIP) of a binary glTF 2.0 file
// as a skeleton for plant_from_lines(). All node transforms are applied, and the lines are
// converted to our frame (millimetres, +z up). Triangles and points are ignored.
//
// Fails if the file is invalid, as read_glb() does, or if it has no lines (in a sentence that
// begins with `name`). Safe for arbitrary bytes.
Result<std::vector<SkeletonPiece>> read_glb_lines(std::string const& name, std::string_view bytes);

} // namespace tractus::exports
