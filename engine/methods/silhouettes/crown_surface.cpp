#include "engine/methods/silhouettes/crown_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::silhouette {

namespace {

std::vector<Vec2> all_in_frame(std::span<Vec2 const> points, TrunkFrame const& frame)
{
    std::vector<Vec2> result;
    for (auto const& point : points)
        result.push_back(frame.of(point));
    return result;
}

// Interpolates between the distances of two meridians from the trunk: 1 / r² is linear in the
// weights. With the weights cos² and sin² the horizontal section is the ellipse through both
// half-axes.
double between_distances(double a, double b, double weight_of_a)
{
    double const least = 1e-9 * std::max({ std::fabs(a), std::fabs(b), 1e-9 });
    if (a <= least || b <= least)
        return weight_of_a * a + (1 - weight_of_a) * b;
    return 1 / std::sqrt(weight_of_a / (a * a) + (1 - weight_of_a) / (b * b));
}

} // namespace

CrownSurface::CrownSurface(std::span<Vec2 const> outline, std::span<Vec2 const> trunk)
    : frame_(trunk)
    , meridians_(split_into_meridians(all_in_frame(outline, frame_), 0))
{
}

CrownSurface::CrownSurface(std::vector<Meridian> meridians, std::span<Vec2 const> trunk)
    : frame_(trunk)
    , meridians_(std::move(meridians))
    , is_drawn_(true)
{
    std::sort(meridians_.begin(), meridians_.end(),
              [](Meridian const& a, Meridian const& b) { return a.theta_deg < b.theta_deg; });
}

Vec2 CrownSurface::at(double s, double theta_deg) const
{
    double const place = std::clamp(s, 0.0, 1.0) * (kPoints - 1);
    auto const i = std::min(static_cast<std::size_t>(place), kPoints - 2);
    double const rest = place - static_cast<double>(i);
    auto const along = [&](Meridian const& meridian) -> Vec2 {
        return meridian.curve[i] + rest * (meridian.curve[i + 1] - meridian.curve[i]);
    };
    if (!is_drawn_) {
        double const w = (1 + std::cos(radians(theta_deg))) / 2;
        return w * along(meridians_[0]) + (1 - w) * along(meridians_[1]);
    }
    double const turn_deg = theta_deg - 360 * std::floor(theta_deg / 360);
    auto const next = std::upper_bound(
        meridians_.begin(), meridians_.end(), turn_deg,
        [](double angle_deg, Meridian const& other) { return angle_deg < other.theta_deg; });
    auto const& after = next == meridians_.end() ? meridians_.front() : *next;
    auto const& before = next == meridians_.begin() ? meridians_.back() : *std::prev(next);
    auto const from_deg = [&](double angle_deg) {
        double const way_deg = angle_deg - before.theta_deg;
        return way_deg < 0 ? way_deg + 360 : way_deg;
    };
    double const gap_deg = from_deg(after.theta_deg);
    double const share = gap_deg > 0 ? from_deg(turn_deg) / gap_deg : 0;
    constexpr double kDense_deg = 15; // Spacing below which the interpolation's steps between
                                      // meridians would be visible as ridges.
    double const w = gap_deg < kDense_deg ? 1 - share : (1 + std::cos(kPi * share)) / 2;
    Vec2 const a = along(before);
    Vec2 const b = along(after);
    return { between_distances(a.x(), b.x(), w), w * a.y() + (1 - w) * b.y() };
}

std::vector<Vec2> CrownSurface::section(double theta_deg) const
{
    std::vector<Vec2> section;
    for (std::size_t i = 0; i < kPoints; ++i)
        section.push_back(at(static_cast<double>(i) / (kPoints - 1), theta_deg));
    // Closes the curve slightly beyond the trunk, so that points close to the trunk are inside.
    section.emplace_back(-section.back().x() - 1e-6, section.back().y());
    double const back = 0.05 * std::max(1e-9, (section.back() - section.front()).norm());
    section.emplace_back(-back, at(0.9, theta_deg).y());
    section.emplace_back(-back, at(0.1, theta_deg).y());
    return section;
}

std::optional<double> CrownSurface::reach(double theta_deg, double height) const
{
    std::optional<double> farthest;
    Vec2 before = at(0, theta_deg);
    for (std::size_t i = 1; i < kPoints; ++i) {
        Vec2 const point = at(static_cast<double>(i) / (kPoints - 1), theta_deg);
        double const rise = point.y() - before.y();
        double const share = rise != 0 ? (height - before.y()) / rise : -1;
        if (share >= 0 && share <= 1) {
            double const far = before.x() + share * (point.x() - before.x());
            farthest = std::max(farthest.value_or(far), far);
        }
        before = point;
    }
    return farthest;
}

Vec2 CrownSurface::heights(double theta_deg) const
{
    Vec2 range(1e300, -1e300);
    for (std::size_t i = 0; i < kPoints; ++i) {
        double const height = at(static_cast<double>(i) / (kPoints - 1), theta_deg).y();
        range = { std::min(range.x(), height), std::max(range.y(), height) };
    }
    return range;
}

bool CrownSurface::holds(Vec3 const& point) const
{
    double const theta_deg = degrees(std::atan2(point.y(), point.x()));
    return is_inside(section(theta_deg), Vec2(point.head<2>().norm(), point.z()));
}

} // namespace tractus::silhouette
