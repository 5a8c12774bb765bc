#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/pen_sketch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::lines {

// True if all strokes of a sketch are interpreted together (Reading::Together).
bool is_read_together(PenSketch const& sketch);

// Interpretation of the lines of a sketch, by stem.
struct PenReading {
    std::vector<StemLines> stems; // Stems of the sketch, with numbers of nodes and organs.
    // Indices, among the sketch's lines, of the strokes of each stem's inclination lines.
    std::vector<std::vector<std::size_t>> inclination_strokes;
    // Interpretation of each line of the sketch, if they are read together; `of` is an index of the
    // sketch's lines.
    std::vector<ExplainedStroke> strokes;
    // Second-best interpretation of the newest line's stem: the role in it of each line of the
    // sketch. Empty if there is none.
    std::vector<Role> second_best_roles;
};
Result<PenReading> read_pen_sketch(PenSketch const& sketch);

// Returns the sketch with the roles that joint interpretation gives its lines; unchanged if it is
// interpreted line by line.
Result<PenSketch> with_roles_read(PenSketch sketch);

// Returns the sketch without the lines that the newest one replaces; it inherits their nodes and
// organs. A sketch that is interpreted line by line is returned unchanged.
Result<PenSketch> without_replaced(PenSketch sketch);

} // namespace tractus::lines
