#pragma once

#include "engine/base/result.h"
#include "engine/export/stroke_svg.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"

#include <filesystem>
#include <span>
#include <vector>

namespace tractus::io {

// True for files that contain strokes in space instead of device reports: .tilt (Open Brush, Tilt
// Brush), .strokes and .txt (stroke_text.h). The extension decides, but a .txt that starts like a
// recording (drivers/logs/foreign_log.h) does not count.
bool is_stroke_file(std::filesystem::path const& path);

// Reads the strokes of a file that is_stroke_file() accepts. Fails with a user error if it cannot
// be read or has another format.
Result<std::vector<Stroke>> load_strokes(std::filesystem::path const& path);

// Returns the strokes of a scene that shape branches. A stroke that shapes several branches is
// included once.
std::vector<Stroke> strokes_of(scene::Scene const& scene);

// True if write_strokes() supports the file's extension: .strokes or .txt (stroke_text.h), .glb
// (stroke_glb.h) or .svg (stroke_svg.h).
bool can_write_strokes_to(std::filesystem::path const& path);

// Writes strokes in the format of the file's extension. `view` is the direction of view for .svg
// files; other formats ignore it. Fails with a user error if the file cannot be written.
Result<void> write_strokes(std::filesystem::path const& path, std::span<Stroke const> strokes,
                           exports::StrokeView view = exports::StrokeView::Front);

} // namespace tractus::io
