#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus {

// Takes the hand's tremor out of a drawn line, by reverse subdivision: the line is reduced to a few
// control points, and their curve is what the hand meant; the rest is the hand.
//
// `detail_weight`, 0 to 1, says how much of that rest stays: 1 gives the points back as they were,
// since an unsteady hand is variation that drawing brings for free (Streit 2006 section 4), and 0
// gives the curve alone. `points`: at least two distinct ones. Both ends stay where they were.
// Below 1 the result has other points than the input, evenly spaced before smoothing, and at least
// as many.
std::vector<Vec3> smooth_hand(std::span<Vec3 const> points, double detail_weight);

} // namespace tractus
