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
    // beyond[e] is the neighbour across the edge from corner e to the next corner; kNoTriangle if
    // that edge is part of the outline.
    std::array<std::uint32_t, 3> beyond {};
};

// Constrained Delaunay triangulation of a simple, counter-clockwise outline without additional
// points: ear clipping followed by edge flips (Lawson). n points (at least 3) give n - 2 triangles.
// No circumcircle contains the opposite corner of a neighbour, up to rounding; for cocircular
// corners the choice of diagonal is arbitrary. Time is at most cubic in n.
std::vector<Triangle> triangulate(std::span<Vec2 const> outline);

// Positive if d is inside the circle through a, b and c, which run counter-clockwise.
double in_circle(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d);

} // namespace tractus::silhouette
