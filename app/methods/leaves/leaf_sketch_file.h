#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_drawing.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::leaf {

// Reads a drawn leaf from JSON, in millimetres:
//
//   strokes  [[[x, y], …], …] or [[[x, y, z], …], …]: in drawing order, z up or towards the viewer;
//            the role of each stroke is recognised
//
// Other keys are ignored. Fails with a user error that names the file, the place and what to write.
Result<leaf::LeafDrawing> parse_leaf_sketch(std::string_view text, std::string const& name);

// Reads a drawn leaf from a file of at most 8 MiB: JSON as for parse_leaf_sketch(), or an SVG
// drawing (.svg), each line of which is a stroke.
Result<leaf::LeafDrawing> load_leaf_sketch(std::filesystem::path const& path);

} // namespace tractus::leaf
