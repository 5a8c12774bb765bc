#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>

namespace tractus {

// A bicubic Bézier surface with parameters s and t from 0 to 1: s varies across the four rows of
// control points, t along a row.
struct BezierPatch {
    static constexpr std::uint16_t kNoPatch = 0xffff;
    enum Side { Above, Below, Left, Right }; // The sides s = 0, s = 1, t = 0 and t = 1.

    std::array<Vec3, 16> control; // Control points, row by row.
    // The adjacent patch at each side, by Side: its index in the list that contains this patch, or
    // kNoPatch.
    std::array<std::uint16_t, 4> neighbors { kNoPatch, kNoPatch, kNoPatch, kNoPatch };

    Vec3 at(double s, double t) const;
    // Returns the normal dS/ds x dS/dt, not normalised; zero where there is no tangent plane.
    Vec3 normal_at(double s, double t) const;
};

// The spline basis in which 16 control points define a bicubic surface.
enum class PatchBasis { Bezier, BSpline, Cardinal };

// Converts control points to those of the same surface as a Bézier patch. A B-spline or cardinal
// surface spans the area between the inner four points.
std::array<Vec3, 16> bezier_control(std::array<Vec3, 16> const& control, PatchBasis basis);

} // namespace tractus
