#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// The sketch's sheet: u to the right, v up, millimetres. Directions on it are angles from up,
// counter-clockwise, so to the left, positive; degrees.

// The unit vector of a direction.
Vec2 direction(double heading_deg);

// The third coordinate of the cross product: positive where `b` points to the left of `a`.
double cross(Vec2 const& a, Vec2 const& b);

// Points of a line, (u, v) or (u, v, depth), without those that stand where the one before them
// does on the sheet.
constexpr double kSamePoint_mm = 1e-6;
template<typename Point> std::vector<Point> without_repeats(std::vector<Point> const& points)
{
    std::vector<Point> result;
    for (auto const& point : points)
        if (result.empty() || (point - result.back()).template head<2>().norm() > kSamePoint_mm)
            result.push_back(point);
    return result;
}

// The directions of a polyline's pieces, without jumps by full turns.
std::vector<double> piece_headings_deg(std::span<Vec2 const> points);

// From a value for each piece to one for each point: the mean of the two pieces that meet there,
// and at the ends what carries the change on.
std::vector<double> values_at_points(std::span<double const> piece_values);

// A line on the sheet, asked by the length along it.
class DrawnLine {
public:
    // At least two points, no two neighbours equal; all finite.
    explicit DrawnLine(std::vector<Vec2> points);

    std::span<Vec2 const> points() const { return points_; }
    double length_mm() const { return at_mm_.back(); }

    Vec2 point(double at_mm) const;

    // The direction of the tangent: of a point the mean of its two pieces', linear between points.
    double heading_deg(double at_mm) const;

    // How far along each point is; and the piece that a length falls on, with the share of the
    // piece that lies before it.
    std::span<double const> at_mm() const { return at_mm_; }
    struct Place {
        std::size_t piece = 0;
        double share = 0;
    };
    Place place(double at_mm) const;

    // How far along it the point is that lies nearest to another one.
    double nearest_mm(Vec2 const& point) const;

    // How far a point is from the line: above 0 on its left, below 0 on its right. Beyond its ends
    // the line goes on straight.
    double distance_mm(Vec2 const& point) const;

    // How far along a ray the line is met first; no value if it is not. `way` is a unit vector.
    std::optional<double> nearest_hit_mm(Vec2 const& from, Vec2 const& way) const;

private:
    std::vector<Vec2> points_;
    std::vector<double> at_mm_;
    std::vector<double> heading_deg_; // Of each point.
};

// Which of `rising` numbers, at least two, a value falls behind, and the share of the way to the
// next.
DrawnLine::Place place_in(std::span<double const> rising, double value);

// Linear between the values at the rising numbers.
double value_in(std::span<double const> values, DrawnLine::Place const& place);

// Points at the other side of a line: each as far beyond it as it was before it. Beyond its ends
// the line goes on straight.
std::vector<Vec2> mirrored(DrawnLine const& line, std::span<Vec2 const> points);

// Where two lines cross: how far along each of them.
struct Crossing {
    double first_mm = 0;
    double second_mm = 0;
};

// Their crossings in the order of `first`, as many as a drawn line may have: a scribble has more
// than anybody needs. Pieces that run along each other do not cross. Takes time in proportion to
// the product of the numbers of points.
constexpr std::size_t kMostCrossings = 1'000;
std::vector<Crossing> crossings(DrawnLine const& first, DrawnLine const& second);

} // namespace tractus::lines
