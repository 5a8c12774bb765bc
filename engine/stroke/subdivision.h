#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus {

// One round of Chaikin's corner cutting with both ends kept: the limit is the quadratic B-spline
// curve of the control points. n points (at least 2) become 2n - 2.
std::vector<Vec3> subdivide(std::span<Vec3 const> coarse);

// One round backwards: 2n - 2 points (even, at least 4) become the n whose subdivision lies near
// them. Local filters of Samavati and Bartels ("Local B-spline multiresolution with examples in
// iris synthesis and volumetric rendering", 2007): what subdivide() made comes back without loss.
std::vector<Vec3> reverse_subdivide(std::span<Vec3 const> fine);

} // namespace tractus
