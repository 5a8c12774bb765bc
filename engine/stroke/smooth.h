#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus {

// Removes hand tremor from a drawn line by reverse subdivision: the line is reduced to a small
// number of control points, whose curve is the intended line. The difference between the two lines
// is tremor and detail.
//
// `detail_weight`, 0 to 1, is the share of the detail that is kept. 1 returns the points unchanged,
// since an unsteady hand is natural variation (Streit 2006, section 4); 0 returns the curve alone.
// `points`: at least two distinct ones. Both ends keep their positions. Below 1 the line is first
// resampled at equal distances, so the result has other points than the input, and at least as
// many.
std::vector<Vec3> smooth_hand_line(std::span<Vec3 const> points, double detail_weight);

} // namespace tractus
