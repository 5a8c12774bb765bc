#pragma once

#include "app/methods/construction_lines/line_sketch_file.h"
#include "engine/base/result.h"
#include "engine/methods/construction_lines/composed_model.h"
#include "engine/methods/construction_lines/several_stems.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lines {

// Whether the lines of a file are used unchanged or smoothed like the strokes of a pen
// (capture_line()).
enum class Smoothing { None, Hand };

// A sketch whose lines are ready to be measured.
struct LineDrawing {
    std::vector<StemLines> stems;
    // Recognised roles of all strokes for which the file gives no role, in the strokes' order.
    std::vector<std::string> roles;
    // Index of the stem to which each stroke belongs, in the strokes' order.
    std::vector<std::size_t> stems_of_strokes;
    // For each stroke that continues or replaces an earlier line: the index of that line's first
    // stroke. No value for other strokes.
    std::vector<std::optional<std::size_t>> lines_of_strokes;
    // Indices of the strokes that are not used as a line of the sketch, in ascending order.
    std::vector<std::size_t> unplaced;
    // One sentence for each stroke that is ignored or was changed or interpreted, with the reason.
    std::vector<std::string> notes;
};

// Prepares a file's sketch for measuring. Unsorted strokes are first sorted by stem; the strokes of
// a stem are then interpreted together (explain_sketch.h). Fails with a user error if all strokes
// are only dots.
Result<LineDrawing> prepare_drawing(LineSketchFile const& file, Smoothing smoothing);

// Combines a sketch with the sketches that serve as its organs, and reads the files of these other
// sketches. `path` and `file` are the first sketch, and `stems` its measured stems. Guesses made in
// the other sketches are added to `notes`. Fails with a user error that names the file, if a file
// is invalid or cannot be measured, if a sketch of several stems has other sketches as organs or is
// an organ, or if a sketch contains itself.
Result<ComposedSketch> load_composed(std::filesystem::path const& path, LineSketchFile const& file,
                                     std::vector<MeasuredStem> const& stems, Smoothing smoothing,
                                     std::vector<std::string>& notes);

} // namespace tractus::lines
