#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <filesystem>
#include <vector>

namespace tractus {

// True for files that hold strokes in space instead of the reports of devices: .tilt (Open Brush,
// Tilt Brush), .strokes and .txt (stroke_text.h). By the ending alone.
bool is_stroke_file(std::filesystem::path const& path);

// The strokes in such a file. Fails, as the user's fault, if it cannot be read or is no such file.
Result<std::vector<Stroke>> load_strokes(std::filesystem::path const& path);

} // namespace tractus
