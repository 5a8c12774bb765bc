#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus {

struct BSplineOptions {
    // Degree of the curve, 2 or 3. If there are too few control points for it, the highest degree
    // that they allow is used.
    int degree = 3;

    enum class Ends {
        Clamped, // The curve begins at the first control point and ends at the last.
        Uniform, // Uniform knots: the curve begins and ends near the outer control points.
    };
    Ends ends = Ends::Clamped;
};

// Returns the point of a B-spline curve at parameter `t`, from 0 (beginning) to 1 (end), clamped to
// this range, by de Boor's algorithm. `control` needs at least one point.
Vec3 bspline_point(std::span<Vec3 const> control, double t, BSplineOptions const& options = {});

// Returns `count` points (at least 2) at equal steps of t, including both ends.
std::vector<Vec3> bspline_points(std::span<Vec3 const> control, std::size_t count,
                                 BSplineOptions const& options = {});

} // namespace tractus
