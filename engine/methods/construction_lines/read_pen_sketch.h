#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/pen_sketch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::lines {

// Whether all strokes of a sketch are read together (Reading::Together).
bool is_read_together(PenSketch const& sketch);

// What the lines of a sketch are, stem by stem.
struct PenReading {
    std::vector<StemLines> stems; // With numbers of nodes and organs.
    // For each stem the numbers, among the sketch's lines, of the strokes of its inclination lines.
    std::vector<std::vector<std::size_t>> inclination_strokes;
    // For each line of the sketch, if they are read together; `of` counts the sketch's lines.
    std::vector<ExplainedStroke> strokes;
    // What the newest line's stem would be if the best reading were wrong: for each line of the
    // sketch its role in the second best one. Empty where there is none.
    std::vector<Role> second_thought;
};
Result<PenReading> read_pen_sketch(PenSketch const& sketch);

// The sketch whose lines have the roles that a reading together gives them; one that is read line
// by line as it is.
Result<PenSketch> with_roles_read(PenSketch sketch);

// The sketch without lines in whose place the newest one stands, which inherits their nodes and
// organs. The same.
Result<PenSketch> without_replaced(PenSketch sketch);

} // namespace tractus::lines
