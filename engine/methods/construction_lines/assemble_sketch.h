#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/stem_candidates.h"

#include <span>
#include <vector>

namespace tractus::lines {

// Builds the sketch from strokes, including the stem's, of which each has a known Part: joins
// pieces, inserts corrections, splits outlines at the stem, and combines halves of inclination
// lines. An inclination line that makes the sketch impossible to measure becomes Unsure, with the
// reason. `lines` are the strokes after the removal of hooks and tremor. The cost of the result is
// not set.
Explanation assemble_sketch(std::span<Polyline const> lines,
                            std::span<StrokeToExplain const> strokes, StemCandidate const& stem,
                            std::span<Part const> parts);

} // namespace tractus::lines
