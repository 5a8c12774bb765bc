#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus {

struct BSplineOptions {
    // Degree of the curve, 2 or 3. If there are too few control points for this degree, the highest
    // degree that their number allows is used.
    int degree = 3;

    enum class Ends {
        Clamped, // The curve begins at the first control point and ends at the last.
        Uniform, // Uniform knots: the curve begins and ends near the outer control points.
    };
    Ends ends = Ends::Clamped;
};

// Returns the point of a B-spline curve at parameter `t`, by de Boor's algorithm. `t` is clamped to
// 0 (beginning of the curve) to 1 (end). `control` needs at least one point.
Vec3 bspline_point(std::span<Vec3 const> control, double t, BSplineOptions const& options = {});

// Returns `count` points (at least 2) of the curve at equal steps of its parameter, including both
// ends.
std::vector<Vec3> bspline_points(std::span<Vec3 const> control, std::size_t count,
                                 BSplineOptions const& options = {});

} // namespace tractus
