#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// Geometry of lines on the sketch's sheet: u to the right, v up, millimetres. Headings are angles
// from up, positive to the left (counter-clockwise); degrees.

// Returns the unit vector of a heading.
Vec2 direction(double heading_deg);

// The third component of the cross product: positive if `b` points to the left of `a`.
double cross(Vec2 const& a, Vec2 const& b);

// Removes points of a line, (u, v) or (u, v, depth), that coincide on the sheet with the one
// before.
constexpr double kSamePoint_mm = 1e-6;
template<typename Point> std::vector<Point> without_repeats(std::vector<Point> const& points)
{
    std::vector<Point> result;
    for (auto const& point : points)
        if (result.empty() || (point - result.back()).template head<2>().norm() > kSamePoint_mm)
            result.push_back(point);
    return result;
}

// Returns the headings of a polyline's segments, without jumps by full turns.
std::vector<double> piece_headings_deg(std::span<Vec2 const> points);

// Converts values of segments to values at points: the mean of the two adjacent segments,
// extrapolated at the ends.
std::vector<double> values_at_points(std::span<double const> piece_values);

// A line on the sheet, parametrised by arc length.
class DrawnLine {
public:
    // The points, at least two, must be finite, with no two equal neighbours.
    explicit DrawnLine(std::vector<Vec2> points);

    std::span<Vec2 const> points() const { return points_; }
    double length_mm() const { return at_mm_.back(); }

    Vec2 point(double at_mm) const;

    // Heading of the tangent: at a point the mean of its two segments, linear between points.
    double heading_deg(double at_mm) const;

    // Arc length at each point. A Place is the segment that contains an arc length, with the share
    // of the segment before it.
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
    std::vector<double> heading_deg_; // Heading at each point.
};

// Finds the interval of the ascending numbers (at least two) that contains a value, and its
// relative position in it.
DrawnLine::Place place_in(std::span<double const> rising, double value);

// Linear interpolation of values at the place found by place_in().
double value_in(std::span<double const> values, DrawnLine::Place const& place);

// Mirrors points about a line, each to the same distance on its other side. The line is extended
// straight beyond its ends.
std::vector<Vec2> mirrored(DrawnLine const& line, std::span<Vec2 const> points);

// Intersection of two lines: arc length along each.
struct Crossing {
    double first_mm = 0;
    double second_mm = 0;
};

// Returns the intersections in the order of `first`, at most kMaxCrossings (only a scribble has
// more). Collinear segments do not intersect. Takes time proportional to the product of the numbers
// of points.
constexpr std::size_t kMaxCrossings = 1'000;
std::vector<Crossing> crossings(DrawnLine const& first, DrawnLine const& second);

} // namespace tractus::lines
