#pragma once

#include "engine/base/result.h"
#include "engine/plant/skeleton_lines.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Reads the lines (primitives of modes LINES, LINE_LOOP and LINE_STRIP) of a binary glTF 2.0 file,
// with all node transforms applied, converted to our frame (millimetres, +z up): a skeleton for
// plant_from_lines(). Triangles and points are ignored.
//
// Fails like read_glb(), or if the file has no lines, in a sentence with `name`. Safe for arbitrary
// bytes.
Result<std::vector<SkeletonPiece>> read_glb_lines(std::string const& name, std::string_view bytes);

} // namespace tractus::exports
