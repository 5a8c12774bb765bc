#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/join_lines.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::lines {

// What may be the stem of a sketch.
struct StemCandidate {
    std::vector<std::size_t> strokes; // One, or pieces that go on in each other.
    Polyline line;                    // In the direction in which the first of them was drawn.
    double cost = 0; // For what is short in the sketch, bends back, lies, or was not drawn first.
};

// At most 24 of them, by their cost. If somebody has said of a stroke that it is the stem, that
// one alone. `lines` are the strokes' without hooks and tremor.
std::vector<StemCandidate> stem_candidates(std::span<Polyline const> lines,
                                           std::span<StrokeToExplain const> strokes);

// The candidate with what else was read as its stem: each stroke over what was drawn before it.
struct CorrectedStem {
    Polyline line;
    std::vector<std::size_t> strokes;  // All of them, in the order in which they were drawn.
    std::vector<std::size_t> replaced; // Of which nothing is left.
};
CorrectedStem corrected_stem(StemCandidate const& stem, std::span<Polyline const> lines,
                             std::span<Part const> parts);

} // namespace tractus::lines
