#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// Geometry of the plane that a silhouette is drawn in: x to the right, y up. Lengths are in
// whatever unit the points are. An outline is closed: its last point is joined to its first.
namespace tractus::silhouette {

// The z component of the cross product: above 0 where b is to the left of a.
inline double cross(Vec2 const& a, Vec2 const& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// Counter-clockwise.
Vec2 turned(Vec2 const& v, double angle_rad);

// The same direction with length 1; `otherwise` for what has no length.
Vec2 direction_of(Vec2 const& v, Vec2 const& otherwise = Vec2::UnitY());

// Above 0 if the outline runs counter-clockwise.
double signed_area(std::span<Vec2 const> outline);

// By even and odd crossings.
bool is_inside(std::span<Vec2 const> outline, Vec2 const& point);

double distance_to_segment(Vec2 const& point, Vec2 const& a, Vec2 const& b);
double distance_to_outline(std::span<Vec2 const> outline, Vec2 const& point);
double distance_to_line(Vec2 const& point, std::span<Vec2 const> line); // An open one.

// Where a ray meets the outline first, as a multiple of `ahead`; no value: it does not.
std::optional<double> way_to_outline(std::span<Vec2 const> outline, Vec2 const& from,
                                     Vec2 const& ahead);

// How far the farthest of the points that are outside is from the outline; 0: all are inside.
double excursion(std::span<Vec2 const> outline, std::span<Vec2 const> points);

// Whether two segments cross in a point inside of both.
bool do_cross(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d);

struct Box {
    Vec2 low = Vec2::Zero();
    Vec2 high = Vec2::Zero();

    double diagonal() const { return (high - low).norm(); }
    Vec2 middle() const { return (low + high) / 2; }
};
Box box_of(std::span<Vec2 const> points); // Of at least one.

double length_of(std::span<Vec2 const> points); // Of an open line.

// `count` points at equal distances along an open line, both ends among them, and around an
// outline, its first point among them. At least one point is given, two are asked for.
std::vector<Vec2> resampled_line(std::span<Vec2 const> points, std::size_t count);
std::vector<Vec2> resampled_outline(std::span<Vec2 const> points, std::size_t count);

// A cubic by its ends and the derivatives there (Hermite).
struct Cubic {
    Vec2 base = Vec2::Zero();
    Vec2 end = Vec2::Zero();
    Vec2 base_tangent = Vec2::Zero();
    Vec2 end_tangent = Vec2::Zero();

    Vec2 at(double x) const; // x from 0 to 1.
    std::vector<Vec2> points(std::size_t count) const;
};

// Moves, turns, scales, and mirrors (by a turn after y has changed its sign).
struct Similarity {
    Vec2 from = Vec2::Zero();  // This point
    Vec2 to = Vec2::Zero();    // goes here.
    Vec2 turn = Vec2::UnitX(); // The image of (1, 0): its length is the scale.
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

// The turn of a similarity that takes `from` to `to`, as long as both are: for one that mirrors,
// and for one that does not.
Vec2 turn_between(Vec2 const& from, Vec2 const& to, bool mirrors);

} // namespace tractus::silhouette
