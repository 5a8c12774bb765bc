#include "engine/methods/silhouettes/meridian.h"

#include "engine/methods/silhouettes/crown_surface.h"

#include <algorithm>
#include <cmath>

namespace tractus::silhouette {

TrunkFrame::TrunkFrame(std::span<Vec2 const> trunk)
    : TrunkFrame(trunk.front(), direction_of(trunk.back() - trunk.front()))
{
}

TrunkFrame::TrunkFrame(Vec2 const& foot, Vec2 const& up)
    : foot_(foot)
    , up_(up)
{
}

Vec2 TrunkFrame::of(Vec2 const& point) const
{
    Vec2 const way = point - foot_;
    return { cross(way, up_), way.dot(up_) };
}

Vec3 TrunkFrame::of(Vec3 const& point) const
{
    Vec2 const flat = of(Vec2(point.head<2>()));
    return { flat.x(), point.z(), flat.y() };
}

Vec2 TrunkFrame::to_sheet(Vec2 const& point) const
{
    return foot_ + point.x() * Vec2(up_.y(), -up_.x()) + point.y() * up_;
}

std::vector<Meridian> split_into_meridians(std::span<Vec2 const> outline, double theta_deg)
{
    auto const n = outline.size();
    std::size_t low = 0;
    std::size_t top = 0;
    double best_low = 1e300;
    double best_top = 1e300;
    for (std::size_t i = 0; i < n; ++i) {
        double const off = 3 * std::fabs(outline[i].x());
        if (outline[i].y() + off < best_low)
            best_low = outline[i].y() + off, low = i;
        if (-outline[i].y() + off < best_top)
            best_top = -outline[i].y() + off, top = i;
    }
    // The outline is counter-clockwise, so from the foot it first goes up on the right.
    std::vector<Vec2> right;
    std::vector<Vec2> left;
    for (auto i = low;; i = (i + 1) % n) {
        right.push_back(outline[i]);
        if (i == top)
            break;
    }
    for (auto i = top;; i = (i + 1) % n) {
        left.push_back(outline[i]);
        if (i == low)
            break;
    }
    std::reverse(left.begin(), left.end());
    for (auto& point : left)
        point.x() = -point.x();
    return { { theta_deg, resampled_line(right, CrownSurface::kPoints) },
             { std::fmod(theta_deg + 180, 360), resampled_line(left, CrownSurface::kPoints) } };
}

} // namespace tractus::silhouette
