#pragma once

#include "engine/base/result.h"
#include "engine/export/stroke_svg.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"

#include <filesystem>
#include <span>
#include <vector>

namespace tractus::io {

// True for files that contain strokes in space rather than device reports: .tilt (Open Brush, Tilt
// Brush), .strokes and .txt (stroke_text.h). Decided by extension, except for a .txt that starts
// like a recording (drivers/logs/foreign_log.h).
bool is_stroke_file(std::filesystem::path const& path);

// Reads the strokes of a file that is_stroke_file() accepts. Fails with a user error if it cannot
// be read or has another format.
Result<std::vector<Stroke>> load_strokes(std::filesystem::path const& path);

// The strokes of a scene that shape branches, each once, however many branches it shapes.
std::vector<Stroke> strokes_of(scene::Scene const& scene);

// True if write_strokes() supports the file's extension: .strokes or .txt (stroke_text.h), .glb
// (stroke_glb.h) or .svg (stroke_svg.h).
bool can_write_strokes_to(std::filesystem::path const& path);

// Writes strokes in the format of the file's extension. `view` applies only to .svg. Fails with a
// user error if the file cannot be written.
Result<void> write_strokes(std::filesystem::path const& path, std::span<Stroke const> strokes,
                           exports::StrokeView view = exports::StrokeView::Front);

} // namespace tractus::io
