#include "engine/methods/silhouettes/monotone_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tractus::silhouette {

// Slope at an end of the curve: from the parabola through three points, limited so that the curve
// stays monotone.
static double end_slope(double near, double far, double near_step, double far_step)
{
    double const slope
        = ((2 * near_step + far_step) * near - near_step * far) / (near_step + far_step);
    if (slope * near <= 0)
        return 0;
    if (near * far <= 0 && std::fabs(slope) > 3 * std::fabs(near))
        return 3 * near;
    return slope;
}

MonotoneCurve::MonotoneCurve(std::vector<Vec2> points)
    : points_(std::move(points))
    , slopes_(points_.size(), 0)
{
    auto const last = points_.size() - 1;
    if (last == 0)
        return;
    std::vector<double> steps;
    std::vector<double> rises;
    for (std::size_t i = 0; i < last; ++i) {
        Vec2 const way = points_[i + 1] - points_[i];
        steps.push_back(way.x());
        rises.push_back(way.y() / way.x());
    }
    if (last == 1) {
        slopes_ = { rises[0], rises[0] };
        return;
    }
    for (std::size_t i = 1; i < last; ++i) {
        if (rises[i - 1] * rises[i] <= 0)
            continue;
        double const before = 2 * steps[i] + steps[i - 1];
        double const after = steps[i] + 2 * steps[i - 1];
        slopes_[i] = (before + after) / (before / rises[i - 1] + after / rises[i]);
    }
    slopes_[0] = end_slope(rises[0], rises[1], steps[0], steps[1]);
    slopes_[last] = end_slope(rises[last - 1], rises[last - 2], steps[last - 1], steps[last - 2]);
}

double MonotoneCurve::at(double x) const
{
    if (x <= points_.front().x())
        return points_.front().y() + slopes_.front() * (x - points_.front().x());
    if (x >= points_.back().x())
        return points_.back().y() + slopes_.back() * (x - points_.back().x());
    auto const next = std::upper_bound(points_.begin(), points_.end(), x,
                                       [](double at, Vec2 const& point) { return at < point.x(); });
    auto const i = static_cast<std::size_t>(next - points_.begin()) - 1;
    double const step = points_[i + 1].x() - points_[i].x();
    double const s = (x - points_[i].x()) / step;
    double const s2 = s * s;
    double const s3 = s2 * s;
    return (2 * s3 - 3 * s2 + 1) * points_[i].y() + (s3 - 2 * s2 + s) * step * slopes_[i]
        + (3 * s2 - 2 * s3) * points_[i + 1].y() + (s3 - s2) * step * slopes_[i + 1];
}

} // namespace tractus::silhouette
