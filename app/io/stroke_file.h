#pragma once

#include "engine/base/result.h"
#include "engine/export/stroke_svg.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"

#include <filesystem>
#include <span>
#include <vector>

namespace tractus::io {

// True for files that hold strokes in space instead of the reports of devices: .tilt (Open Brush,
// Tilt Brush), .strokes and .txt (stroke_text.h). By the ending, but for a .txt whose first lines
// are of a recording (drivers/logs/foreign_log.h).
bool is_stroke_file(std::filesystem::path const& path);

// The strokes in such a file. Fails, as the user's fault, if it cannot be read or is no such file.
Result<std::vector<Stroke>> load_strokes(std::filesystem::path const& path);

// Returns what is drawn of a scene: the strokes that shape branches, each once, however many it
// shapes.
std::vector<Stroke> strokes_of(scene::Scene const& scene);

// Whether write_strokes() writes such a file, by its ending alone: .strokes or .txt
// (stroke_text.h), .glb (stroke_glb.h) or .svg (stroke_svg.h).
bool is_written_of_strokes(std::filesystem::path const& path);

// Writes strokes as the file's ending says. `view` is for .svg alone. Fails, as the user's fault,
// if the file cannot be written.
Result<void> write_strokes(std::filesystem::path const& path, std::span<Stroke const> strokes,
                           exports::StrokeView view = exports::StrokeView::Front);

} // namespace tractus::io
