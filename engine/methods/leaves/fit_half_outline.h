#pragma once

#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <optional>
#include <vector>

namespace tractus::leaf {

// A half outline as drawn, from (0, 0) to (0, 1), its x to its own side: as few points as leave the
// curve through them (HalfOutline) within `tolerance` of it in the mean, span by span. Points are
// corners where the line breaks by 50 degrees and more and no smooth curve fits. `window` is the
// length over which the hand's tremor does not hide a corner.
std::vector<HalfOutline::Point> fit_half_outline(FlatLine const& half, double tolerance,
                                                 double window);

// The line halfway between two half outlines whose corners correspond. No value where they do not.
std::optional<FlatLine> mean_half(FlatLine const& a, FlatLine const& b, double window);

// Where a half outline is left, in points, where it turns sharply.
std::vector<std::size_t> corners_of_half(FlatLine const& half, double window);

} // namespace tractus::leaf
