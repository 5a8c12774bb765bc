#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// Geometry in the plane of a silhouette: x to the right, y up. Lengths are in the unit of the
// points. An outline is closed: its last point is joined to its first.
namespace tractus::silhouette {

// The z component of the cross product: positive if b is to the left of a.
inline double cross(Vec2 const& a, Vec2 const& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Rotates a vector counter-clockwise.
Vec2 turned(Vec2 const& v, double angle_rad);

// Unit vector of v; `otherwise` if v has no length.
Vec2 direction_of(Vec2 const& v, Vec2 const& otherwise = Vec2::UnitY());

// Area of an outline, positive if it runs counter-clockwise.
double signed_area(std::span<Vec2 const> outline);

// True if a point is inside an outline by the even-odd rule.
bool is_inside(std::span<Vec2 const> outline, Vec2 const& point);

double distance_to_segment(Vec2 const& point, Vec2 const& a, Vec2 const& b);
double distance_to_outline(std::span<Vec2 const> outline, Vec2 const& point);
// Distance of a point from an open polyline.
double distance_to_line(Vec2 const& point, std::span<Vec2 const> line);

// Distance to the first intersection of a ray with the outline, as a multiple of the length of
// `ahead`; no value if the ray does not meet the outline.
std::optional<double> ray_distance_to_outline(std::span<Vec2 const> outline, Vec2 const& from,
                                              Vec2 const& ahead);

// Greatest distance of the points outside an outline from the outline; 0 if all points are inside.
double excursion(std::span<Vec2 const> outline, std::span<Vec2 const> points);

// True if two segments cross at a point interior to both.
bool do_cross(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d);

struct Box {
    Vec2 low = Vec2::Zero();
    Vec2 high = Vec2::Zero();

    double diagonal() const { return (high - low).norm(); }
    Vec2 middle() const { return (low + high) / 2; }
};
Box box_of(std::span<Vec2 const> points); // Bounding box of points, at least one.

double length_of(std::span<Vec2 const> points); // Length of an open polyline.

// Returns `count` (at least two) equally spaced points along an open polyline, both ends included,
// or around an outline, beginning with its first point. There must be at least one input point.
std::vector<Vec2> resampled_line(std::span<Vec2 const> points, std::size_t count);
std::vector<Vec2> resampled_outline(std::span<Vec2 const> points, std::size_t count);

// A cubic Hermite curve, defined by its ends and the derivatives there.
struct Cubic {
    Vec2 base = Vec2::Zero();
    Vec2 end = Vec2::Zero();
    Vec2 base_tangent = Vec2::Zero();
    Vec2 end_tangent = Vec2::Zero();

    Vec2 at(double x) const; // Point of the curve at x, from 0 to 1.
    std::vector<Vec2> points(std::size_t count) const;
};

// A similarity transform: translation, rotation and scaling; if it mirrors, y changes its sign
// before the rotation.
struct Similarity {
    Vec2 from = Vec2::Zero();  // A point that the similarity maps to `to`.
    Vec2 to = Vec2::Zero();    // Image of the point `from`.
    Vec2 turn = Vec2::UnitX(); // Image of the vector (1, 0); its length is the scale.
    bool mirrors = false;

    Vec2 vector(Vec2 const& v) const
    {
        double const y = mirrors ? -v.y() : v.y();
        return { turn.x() * v.x() - turn.y() * y, turn.y() * v.x() + turn.x() * y };
    }
    Vec2 point(Vec2 const& p) const { return to + vector(p - from); }
    std::vector<Vec2> points(std::span<Vec2 const> line) const;
    Cubic cubic(Cubic const& curve) const;
};

// Similarity::turn of a rotation that maps the direction of `from` to that of `to`, multiplied by
// the lengths of both. `mirrors`: the rotation follows a mirroring.
Vec2 turn_between(Vec2 const& from, Vec2 const& to, bool mirrors);

} // namespace tractus::silhouette
