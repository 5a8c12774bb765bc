#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/stroke/stroke.h"

#include <algorithm>
#include <span>
#include <vector>

namespace tractus {

// Returns the positions of a stroke's tips, in order, without consecutive duplicates. World frame,
// millimetres.
//
// Fails, in one sentence, if the stroke has no direction: a coordinate is not finite, or there are
// fewer than two distinct points. A stroke that ends where it began is accepted.
Result<std::vector<Vec3>> stroke_points(Stroke const& stroke);

// Returns the points without consecutive duplicates. Fails like stroke_points().
Result<std::vector<Vec3>> distinct_points(std::span<Vec3 const> points);

// Returns the arc length of the polyline.
double polyline_length_mm(std::span<Vec3 const> points);

// Returns the parameter, 0 to 1, of the point nearest to `place` on the line segment from `from` to
// `to`.
template<typename Vector>
double nearest_share(Vector const& place, Vector const& from, Vector const& to)
{
    Vector const along = to - from;
    double const length2 = along.squaredNorm();
    return length2 > 0 ? std::clamp((place - from).dot(along) / length2, 0.0, 1.0) : 0;
}

} // namespace tractus
