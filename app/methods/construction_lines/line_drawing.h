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

// Whether lines are taken as they are, or as a pen's strokes (capture_line()).
enum class Smoothing { None, Hand };

// A sketch whose lines are ready to be measured.
struct LineDrawing {
    std::vector<StemLines> stems;
    std::vector<std::string> roles; // Of strokes that did not say what they are, in their order,
    std::vector<std::size_t> stems_of_strokes; // and the number of the stem of each.
    // Of each the first stroke of the line that both make, or in whose place it stands; no value:
    // it makes a line by itself.
    std::vector<std::optional<std::size_t>> lines_of_strokes;
    // Strokes that are no line of the sketch, in order.
    std::vector<std::size_t> unplaced;
    std::vector<std::string> notes; // Strokes that do not count, and why; a sentence each.
};

// Strokes are explained together (explain_sketch.h), those of several stems stem by stem. Fails, as
// the user's fault, where all strokes are only dots.
Result<LineDrawing> prepare_drawing(LineSketchFile const& file, Smoothing smoothing);

// The sketch of a file with those that its organs are, whose files are read, too. `stems` are the
// ones measured in it. What had to be guessed in the others is added to `notes`.
//
// Fails, as the user's fault, like load_line_sketch() and measure_stems(), and says of which file;
// and for a sketch of several stems that has such organs, or is one, and where a sketch is an organ
// of itself.
Result<ComposedSketch> load_composed(std::filesystem::path const& path, LineSketchFile const& file,
                                     std::vector<MeasuredStem> const& stems, Smoothing smoothing,
                                     std::vector<std::string>& notes);

} // namespace tractus::lines
