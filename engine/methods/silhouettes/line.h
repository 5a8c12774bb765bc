#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <cstddef>
#include <vector>

namespace tractus::silhouette {

// A polyline that can be evaluated for point and direction at a share of its length.
class Line {
public:
    explicit Line(std::vector<Vec2> points); // The points of the line, at least two.

    double length() const { return to_.back(); }
    Vec2 at(double u) const;
    Vec2 direction(double u) const;

    // Approximate position, as a share of the length, of the point on the line nearest to `point`.
    double place_of(Vec2 const& point) const;

    std::vector<Vec2> const& points() const { return points_; }

private:
    std::size_t piece(double u) const;

    std::vector<Vec2> points_;
    std::vector<double> to_;
};

} // namespace tractus::silhouette
