#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/pen_sketch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::lines {

// True if all strokes of a sketch are interpreted together (Reading::Together).
bool is_read_together(PenSketch const& sketch);

// Interpretation of the lines of a sketch.
struct PenReading {
    std::vector<StemLines> stems; // Lines of each stem, with numbers of nodes and organs.
    // For each stem, the indices, among the sketch's lines, of the strokes of its inclination
    // lines.
    std::vector<std::vector<std::size_t>> inclination_strokes;
    // Interpretation of each line of the sketch, if all lines are interpreted together; otherwise
    // empty. ExplainedStroke::of is an index among the sketch's lines.
    std::vector<ExplainedStroke> strokes;
    // Role of each line of the sketch in the second-best interpretation of the newest line's stem;
    // empty if there is no second interpretation.
    std::vector<Role> second_best_roles;
};
Result<PenReading> read_pen_sketch(PenSketch const& sketch);

// Returns the sketch with the roles that its lines get when they are interpreted together. A sketch
// that is interpreted line by line is returned unchanged.
Result<PenSketch> with_roles_read(PenSketch sketch);

// Returns the sketch without the lines that its newest line replaces. The newest line inherits
// their number of nodes, pattern and organ. A sketch that is interpreted line by line is returned
// unchanged.
Result<PenSketch> without_replaced(PenSketch sketch);

} // namespace tractus::lines
