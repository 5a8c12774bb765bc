#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus {

struct BSplineOptions {
    int degree = 3; // 2 or 3. With too few control points for it, the highest degree they allow.

    enum class Ends {
        Clamped, // The curve begins in the first control point and ends in the last.
        Uniform, // Equal knots: it begins and ends near them.
    };
    Ends ends = Ends::Clamped;
};

// The point of a B-spline curve at `t`, 0 its beginning and 1 its end; outside of that the nearest
// end. At least one control point. De Boor's algorithm.
Vec3 bspline_point(std::span<Vec3 const> control, double t, BSplineOptions const& options = {});

// `count` points (at least 2) at equal steps of t, both ends among them.
std::vector<Vec3> bspline_points(std::span<Vec3 const> control, std::size_t count,
                                 BSplineOptions const& options = {});

} // namespace tractus
