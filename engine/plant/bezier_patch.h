#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>

namespace tractus {

// A bicubic Bézier surface. Point (s, t) of it, both from 0 to 1: s chooses between the four rows
// of control points, t along them.
struct BezierPatch {
    static constexpr std::uint16_t kNoPatch = 0xffff;
    enum Side { Above, Below, Left, Right }; // s = 0, s = 1, t = 0, t = 1.

    std::array<Vec3, 16> control; // Row by row.
    // The patches that go on beyond the four sides, by Side: an index into the same list.
    std::array<std::uint16_t, 4> neighbors { kNoPatch, kNoPatch, kNoPatch, kNoPatch };

    Vec3 at(double s, double t) const;
    // dS/ds x dS/dt: zero where the surface has no tangent plane.
    Vec3 normal_at(double s, double t) const;
};

// How 16 points define a bicubic surface.
enum class PatchBasis { Bezier, BSpline, Cardinal };

// Returns the same surface as Bézier control points. A B-spline's or cardinal spline's surface lies
// between the inner four points.
std::array<Vec3, 16> bezier_control(std::array<Vec3, 16> const& control, PatchBasis basis);

} // namespace tractus
