#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_drawing.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::leaf {

// Reads a drawn leaf from JSON, millimetres:
//
//   strokes  [[[x, y], …], …] or [[[x, y, z], …], …]: in the order in which they were drawn, z up
//            or towards the viewer; what each one is, is recognised
//
// Other keys are for other readers. Fails, as the user's fault, with file, place and what to write.
Result<leaf::LeafDrawing> parse_leaf_sketch(std::string_view text, std::string const& name);

// Reads such a file of at most 8 MiB, which may also be an SVG drawing (.svg): its lines are the
// strokes.
Result<leaf::LeafDrawing> load_leaf_sketch(std::filesystem::path const& path);

} // namespace tractus::leaf
