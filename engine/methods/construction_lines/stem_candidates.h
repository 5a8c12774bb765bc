#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/join_lines.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::lines {

// A candidate for the stem of a sketch.
struct StemCandidate {
    // Indices of the strokes of the candidate: one stroke, or several that continue each other.
    std::vector<std::size_t> strokes;
    Polyline line; // The joined line, in the direction in which the first stroke was drawn.
    // Cost of the candidate. It is higher if the candidate's line is short relative to the sketch,
    // bends back, is nearly horizontal, or was not drawn first.
    double cost = 0;
};

// Returns at most 24 candidates in ascending order of cost. If the user has assigned the role of
// the stem to a stroke, only this stroke is a candidate. `lines` are the strokes without hooks and
// tremor.
std::vector<StemCandidate> stem_candidates(std::span<Polyline const> lines,
                                           std::span<StrokeToExplain const> strokes);

// A stem candidate after all strokes that correct it have been merged into it, in drawing order.
struct CorrectedStem {
    Polyline line;
    std::vector<std::size_t> strokes; // Indices of all strokes of the stem, in drawing order.
    // Indices of the strokes that corrections have replaced completely.
    std::vector<std::size_t> replaced;
};
CorrectedStem corrected_stem(StemCandidate const& stem, std::span<Polyline const> lines,
                             std::span<Part const> parts);

} // namespace tractus::lines
