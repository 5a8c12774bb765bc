#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::silhouette {

constexpr std::uint32_t kNoTriangle = 0xffff'ffff;

// A triangle of an outline: its corners are points of the outline, counter-clockwise.
struct Triangle {
    std::array<std::uint32_t, 3> corner {};
    // Beyond the edge from corner e to the next: kNoTriangle where that edge is the outline's.
    std::array<std::uint32_t, 3> beyond {};
};

// The constrained Delaunay triangulation of a simple outline that runs counter-clockwise, without
// further points: ears are cut off, then edges flipped (Lawson). n points give n - 2 triangles. No
// triangle's circumcircle holds the opposite corner of one beyond its edge by more than rounding;
// of corners on one circle any diagonal may be taken. At least 3 points; the time grows with up to
// the cube of their number.
std::vector<Triangle> triangulate(std::span<Vec2 const> outline);

// Above 0 if d is inside of the circle through a, b and c, which run counter-clockwise.
double in_circle(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d);

} // namespace tractus::silhouette
