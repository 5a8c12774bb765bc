#include "engine/methods/silhouettes/crown_surface.h"

#include <algorithm>
#include <cmath>

namespace tractus::silhouette {

CrownSurface::CrownSurface(std::span<Vec2 const> outline, std::span<Vec2 const> trunk)
    : foot_(trunk.front())
    , up_(direction_of(trunk.back() - trunk.front()))
{
    // The outline is cut where it is nearest to the trunk's line at its lowest and its highest.
    auto const n = outline.size();
    std::size_t low = 0;
    std::size_t top = 0;
    double best_low = 1e300;
    double best_top = 1e300;
    for (std::size_t i = 0; i < n; ++i) {
        Vec2 const at = to_trunk(outline[i]);
        double const off = 3 * std::fabs(at.x());
        if (at.y() + off < best_low)
            best_low = at.y() + off, low = i;
        if (-at.y() + off < best_top)
            best_top = -at.y() + off, top = i;
    }
    std::vector<Vec2> right; // Counter-clockwise from the foot it goes up on the right.
    std::vector<Vec2> left;
    for (auto i = low;; i = (i + 1) % n) {
        right.push_back(to_trunk(outline[i]));
        if (i == top)
            break;
    }
    for (auto i = top;; i = (i + 1) % n) {
        left.push_back(to_trunk(outline[i]));
        if (i == low)
            break;
    }
    std::reverse(left.begin(), left.end());
    for (auto& point : left)
        point.x() = -point.x();
    right_ = resampled_line(right, kPoints);
    left_ = resampled_line(left, kPoints);
}

Vec2 CrownSurface::to_trunk(Vec2 const& point) const
{
    Vec2 const way = point - foot_;
    return { cross(way, up_), way.dot(up_) };
}

Vec2 CrownSurface::at(double s, double theta_deg) const
{
    double const place = std::clamp(s, 0.0, 1.0) * (kPoints - 1);
    auto const i = std::min(static_cast<std::size_t>(place), kPoints - 2);
    double const rest = place - static_cast<double>(i);
    double const w = (1 + std::cos(radians(theta_deg))) / 2;
    auto const between = [&](std::vector<Vec2> const& half) -> Vec2 {
        return half[i] + rest * (half[i + 1] - half[i]);
    };
    return w * between(right_) + (1 - w) * between(left_);
}

std::vector<Vec2> CrownSurface::section(double theta_deg) const
{
    std::vector<Vec2> section;
    for (std::size_t i = 0; i < kPoints; ++i)
        section.push_back(at(static_cast<double>(i) / (kPoints - 1), theta_deg));
    // Back on the other side of the trunk, so that what is near the trunk is inside.
    section.emplace_back(-section.back().x() - 1e-6, section.back().y());
    double const back = 0.05 * std::max(1e-9, (section.back() - section.front()).norm());
    section.emplace_back(-back, at(0.9, theta_deg).y());
    section.emplace_back(-back, at(0.1, theta_deg).y());
    return section;
}

} // namespace tractus::silhouette
