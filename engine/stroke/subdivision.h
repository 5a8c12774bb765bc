#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus {

// One round of Chaikin's corner cutting that keeps both end points. Repeated rounds converge to the
// quadratic B-spline of the control points. n points (at least 2) become 2n - 2.
std::vector<Vec3> subdivide(std::span<Vec3 const> coarse);

// The inverse of one round of subdivide(): 2n - 2 points (an even number, at least 4) become the n
// points whose subdivision lies near them. Uses the local filters of Samavati and Bartels ("Local
// B-spline multiresolution with examples in iris synthesis and volumetric rendering", 2007). Exact
// for points made by subdivide().
std::vector<Vec3> reverse_subdivide(std::span<Vec3 const> fine);

} // namespace tractus
