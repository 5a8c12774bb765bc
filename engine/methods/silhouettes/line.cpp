#include "engine/methods/silhouettes/line.h"

#include <algorithm>
#include <utility>

namespace tractus::silhouette {

Line::Line(std::vector<Vec2> points)
    : points_(std::move(points))
    , to_(1, 0)
{
    for (std::size_t i = 1; i < points_.size(); ++i)
        to_.push_back(to_.back() + (points_[i] - points_[i - 1]).norm());
}

Vec2 Line::at(double u) const
{
    auto const i = piece(u);
    double const width = to_[i + 1] - to_[i];
    double const share = width > 0 ? (u * length() - to_[i]) / width : 0;
    return points_[i] + std::clamp(share, 0.0, 1.0) * (points_[i + 1] - points_[i]);
}

Vec2 Line::direction(double u) const
{
    return direction_of(at(std::min(1.0, u + 0.01)) - at(std::max(0.0, u - 0.01)));
}

double Line::place_of(Vec2 const& point) const
{
    double best = 0;
    double least = 1e300;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        Vec2 const way = points_[i + 1] - points_[i];
        double const share = std::clamp(
            (point - points_[i]).dot(way) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
        double const far = (points_[i] + share * way - point).squaredNorm();
        if (far < least) {
            least = far;
            best = to_[i] + share * way.norm();
        }
    }
    return length() > 0 ? best / length() : 0;
}

std::size_t Line::piece(double u) const
{
    auto const after = std::upper_bound(to_.begin(), to_.end(), u * length());
    auto const i = after - to_.begin() - 1;
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(points_.size()) - 2));
}

} // namespace tractus::silhouette
