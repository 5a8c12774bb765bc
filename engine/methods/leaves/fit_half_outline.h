#pragma once

#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <optional>
#include <vector>

namespace tractus::leaf {

// Fits a curve (HalfOutline) to a drawn half outline, which runs from (0, 0) to (0, 1) with x
// positive on its own side. Returns the fewest points for which the root mean square distance
// between curve and drawing is at most `tolerance` in each span between points. A point is a corner
// if the line turns there by 50 degrees or more and no smooth curve fits almost as well. `window`
// is the length over which a corner can be distinguished from tremor.
std::vector<HalfOutline::Point> fit_half_outline(FlatLine const& half, double tolerance,
                                                 double window);

// Returns the mean of two half outlines; no value unless each corner of one has a counterpart in
// the other.
std::optional<FlatLine> mean_half(FlatLine const& a, FlatLine const& b, double window);

// Returns the indices of the corners among the evenly spaced points of a half outline.
std::vector<std::size_t> corners_of_half(FlatLine const& half, double window);

} // namespace tractus::leaf
