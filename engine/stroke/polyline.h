#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/stroke/stroke.h"

#include <algorithm>
#include <span>
#include <vector>

namespace tractus {

// The places of a stroke's tips, in order, without those that repeat the one before.
//
// Refuses, in a sentence, a stroke that has no direction: one with a number in it that is not
// finite, or with fewer than two distinct points. A stroke that ends where it began is fine.
Result<std::vector<Vec3>> stroke_points(Stroke const& stroke);

// Returns bare points without repeated ones. Refuses the same.
Result<std::vector<Vec3>> distinct_points(std::span<Vec3 const> points);

// Length along the points.
double polyline_length_mm(std::span<Vec3 const> points);

// How far along the way from one point to another, 0 to 1, the line between them is nearest to a
// place.
template<typename Vector>
double nearest_share(Vector const& place, Vector const& from, Vector const& to)
{
    Vector const along = to - from;
    double const length2 = along.squaredNorm();
    return length2 > 0 ? std::clamp((place - from).dot(along) / length2, 0.0, 1.0) : 0;
}

} // namespace tractus
