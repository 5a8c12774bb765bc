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

// Whether a file's lines are used unchanged or smoothed like a pen's strokes (capture_line()).
enum class Smoothing { None, Hand };

// A sketch whose lines are ready to be measured.
struct LineDrawing {
    std::vector<StemLines> stems;
    // Recognised roles of strokes that did not state one, in the strokes' order.
    std::vector<std::string> roles;
    // Index of each stroke's stem, in the strokes' order.
    std::vector<std::size_t> stems_of_strokes;
    // For each stroke that continues or replaces a line, the index of the line's first stroke; no
    // value for other strokes.
    std::vector<std::optional<std::size_t>> lines_of_strokes;
    // Indices of strokes that are not a line of the sketch, ascending.
    std::vector<std::size_t> unplaced;
    // One sentence for each stroke that is ignored, with the reason.
    std::vector<std::string> notes;
};

// Prepares a file's sketch for measuring. Strokes are interpreted together (explain_sketch.h),
// separately for each stem. Fails with a user error if all strokes are only dots.
Result<LineDrawing> prepare_drawing(LineSketchFile const& file, Smoothing smoothing);

// Combines a sketch with the sketches that serve as its organs, and reads the files of these.
// `stems` are the measured stems of the first sketch. Guesses made in the other sketches are added
// to `notes`. Fails with a user error like load_line_sketch() and measure_stems(), naming the file;
// also if a sketch of several stems has such organs or serves as one, and if a sketch contains
// itself.
Result<ComposedSketch> load_composed(std::filesystem::path const& path, LineSketchFile const& file,
                                     std::vector<MeasuredStem> const& stems, Smoothing smoothing,
                                     std::vector<std::string>& notes);

} // namespace tractus::lines
