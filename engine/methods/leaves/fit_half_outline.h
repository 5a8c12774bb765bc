#pragma once

#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <optional>
#include <vector>

namespace tractus::leaf {

// Fits a half outline as drawn, from (0, 0) to (0, 1) with x positive to its own side: the fewest
// points for which the curve through them (HalfOutline) has a root mean square distance of at most
// `tolerance` from the drawing in each span. A point is a corner if the line breaks there by 50
// degrees or more and no smooth curve fits. `window` is the length over which a corner can be
// distinguished from tremor.
std::vector<HalfOutline::Point> fit_half_outline(FlatLine const& half, double tolerance,
                                                 double window);

// The mean of two half outlines with matching corners; no value if the corners do not match.
std::optional<FlatLine> mean_half(FlatLine const& a, FlatLine const& b, double window);

// Positions of the corners of a half outline, as point indices.
std::vector<std::size_t> corners_of_half(FlatLine const& half, double window);

} // namespace tractus::leaf
