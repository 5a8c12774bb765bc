#pragma once

#include "engine/methods/construction_lines/explain_sketch.h"
#include "engine/methods/construction_lines/stem_candidates.h"

#include <span>
#include <vector>

namespace tractus::lines {

// The sketch of strokes of which it is known what each is, the stem's candidate among them: pieces
// joined, corrections put in their places, outlines split at the stem, halves of inclination lines
// brought together. An inclination line with which the sketch cannot be measured is Unsure, with
// the reason. `lines` are the strokes' without hooks and tremor. The result's cost is not set.
Explanation assemble_sketch(std::span<Polyline const> lines,
                            std::span<StrokeToExplain const> strokes, StemCandidate const& stem,
                            std::span<Part const> parts);

} // namespace tractus::lines
