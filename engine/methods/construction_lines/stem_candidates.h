#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/join_lines.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::lines {

// A candidate for the stem of a sketch.
struct StemCandidate {
    // Strokes of the candidate: one, or several that continue each other.
    std::vector<std::size_t> strokes;
    Polyline line; // The joined line, in the direction in which the first stroke was drawn.
    // Cost of the candidate: higher if the line is short relative to the sketch, bends back, is
    // nearly horizontal, or was not drawn first.
    double cost = 0;
};

// Returns at most 24 candidates in order of cost; if the user has marked a stroke as the stem, only
// that. `lines` are the strokes without hooks and tremor.
std::vector<StemCandidate> stem_candidates(std::span<Polyline const> lines,
                                           std::span<StrokeToExplain const> strokes);

// A stem candidate after the strokes that correct it have been applied, in drawing order.
struct CorrectedStem {
    Polyline line;
    std::vector<std::size_t> strokes;  // All strokes of the stem, in drawing order.
    std::vector<std::size_t> replaced; // Strokes that corrections have replaced completely.
};
CorrectedStem corrected_stem(StemCandidate const& stem, std::span<Polyline const> lines,
                             std::span<Part const> parts);

} // namespace tractus::lines
