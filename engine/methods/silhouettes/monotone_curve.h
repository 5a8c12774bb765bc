#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::silhouette {

// A smooth function through points that never rises where they fall (cubic pieces; Fritsch,
// Butland, "A method for constructing local monotone piecewise cubic interpolants", 1984).
class MonotoneCurve {
public:
    // (x, y) by x, all different; at least one.
    explicit MonotoneCurve(std::vector<Vec2> points);

    double at(double x) const; // Beyond the first and the last point as straight on as it ends.

    std::vector<Vec2> const& points() const { return points_; }

private:
    std::vector<Vec2> points_;
    std::vector<double> slopes_;
};

} // namespace tractus::silhouette
