#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// Geometry of lines on the sketch's sheet: u to the right, v up, millimetres. Headings are angles
// in degrees from up, positive to the left (counter-clockwise).

// Returns the unit vector of a heading.
Vec2 direction(double heading_deg);

// The third component of the cross product: positive if `b` points to the left of `a`.
double cross(Vec2 const& a, Vec2 const& b);

// Removes each point of a line, (u, v) or (u, v, depth), that coincides on the sheet with the point
// before it.
constexpr double kSamePoint_mm = 1e-6;
template<typename Point> std::vector<Point> without_repeats(std::vector<Point> const& points)
{
    std::vector<Point> result;
    for (auto const& point : points)
        if (result.empty() || (point - result.back()).template head<2>().norm() > kSamePoint_mm)
            result.push_back(point);
    return result;
}

// Returns the headings of a polyline's segments. Full turns are added where necessary, so that
// consecutive headings differ by at most 180 degrees.
std::vector<double> piece_headings_deg(std::span<Vec2 const> points);

// Converts values of a polyline's segments to values at its points: each inner point gets the mean
// of its two adjacent segments, and the ends are extrapolated linearly.
std::vector<double> values_at_points(std::span<double const> piece_values);

// A line on the sheet, parametrised by arc length.
class DrawnLine {
public:
    // The points must be finite and at least two. No two neighbouring points may be equal.
    explicit DrawnLine(std::vector<Vec2> points);

    std::span<Vec2 const> points() const { return points_; }
    double length_mm() const { return at_mm_.back(); }

    Vec2 point(double at_mm) const;

    // Heading of the tangent. At each point of the polyline it is the mean of the two adjacent
    // segments' headings; in between it is linear.
    double heading_deg(double at_mm) const;

    // Arc length at each point of the line. A Place is a position on the line: the index of a
    // segment, and the share of the segment's length before the position.
    std::span<double const> at_mm() const { return at_mm_; }
    struct Place {
        std::size_t piece = 0;
        double share = 0;
    };
    Place place(double at_mm) const;

    // Arc length of the point nearest to `point`.
    double nearest_mm(Vec2 const& point) const;

    // Signed distance of a point from the line: positive on its left, negative on its right. The
    // line is extended straight beyond its ends.
    double distance_mm(Vec2 const& point) const;

    // Distance along a ray to its first intersection with the line; no value if there is none.
    // `way`: a unit vector.
    std::optional<double> nearest_hit_mm(Vec2 const& from, Vec2 const& way) const;

private:
    std::vector<Vec2> points_;
    std::vector<double> at_mm_;
    std::vector<double> heading_deg_; // Heading of the tangent at each point.
};

// Finds the interval between two of the ascending numbers (at least two) that contains a value, and
// the value's relative position in this interval, 0 to 1.
DrawnLine::Place place_in(std::span<double const> rising, double value);

// Linear interpolation of values at the place found by place_in().
double value_in(std::span<double const> values, DrawnLine::Place const& place);

// Mirrors points about a line: each point moves to the same distance on the other side. The line is
// extended straight beyond its ends.
std::vector<Vec2> mirrored(DrawnLine const& line, std::span<Vec2 const> points);

// An intersection of two lines, as the arc length along each of them.
struct Crossing {
    double first_mm = 0;
    double second_mm = 0;
};

// Returns the intersections of two lines, in ascending order along `first`, at most kMaxCrossings
// (only a scribble has more). Collinear segments do not intersect. Takes time proportional to the
// product of the lines' numbers of points.
constexpr std::size_t kMaxCrossings = 1'000;
std::vector<Crossing> crossings(DrawnLine const& first, DrawnLine const& second);

} // namespace tractus::lines
