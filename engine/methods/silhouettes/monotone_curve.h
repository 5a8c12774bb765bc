#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::silhouette {

// A smooth interpolant that is monotone wherever its points are (piecewise cubic; Fritsch, Butland,
// "A method for constructing local monotone piecewise cubic interpolants", 1984).
class MonotoneCurve {
public:
    // Points (x, y) sorted by x, all x distinct; at least one.
    explicit MonotoneCurve(std::vector<Vec2> points);

    // Value of the curve at x, extrapolated linearly beyond the first and last points.
    double at(double x) const;

    std::vector<Vec2> const& points() const { return points_; }

private:
    std::vector<Vec2> points_;
    std::vector<double> slopes_;
};

} // namespace tractus::silhouette
