#include "sim/path.h"

#include "engine/base/check.h"
#include "engine/stroke/polyline.h"

#include <algorithm>
#include <cmath>

namespace tractus::sim {

static constexpr double kLongest_mm = 10'000;
static constexpr double kStep_mm = 0.5;

Path::Path(std::vector<Vec3> const& points_mm)
{
    for (auto const& point : points_mm) {
        double const step = points_mm_.empty() ? 0 : (point - points_mm_.back()).norm();
        if (!points_mm_.empty() && !(step > 0))
            continue;
        arc_mm_.push_back(arc_mm_.empty() ? 0 : arc_mm_.back() + step);
        points_mm_.push_back(point);
    }
    CHECK(points_mm_.size() >= 2);
}

std::size_t Path::piece_at(double arc_mm) const
{
    auto const after = std::upper_bound(arc_mm_.begin() + 1, arc_mm_.end() - 1, arc_mm);
    return static_cast<std::size_t>(after - arc_mm_.begin() - 1);
}

Vec3 Path::position_mm(double arc_mm) const
{
    auto const i = piece_at(arc_mm);
    double const part = (arc_mm - arc_mm_[i]) / (arc_mm_[i + 1] - arc_mm_[i]);
    return points_mm_[i] + std::clamp(part, 0.0, 1.0) * (points_mm_[i + 1] - points_mm_[i]);
}

Vec3 Path::direction(double arc_mm) const
{
    auto const i = piece_at(arc_mm);
    return (points_mm_[i + 1] - points_mm_[i]).normalized();
}

// Samples a curve over u from 0 to 1 in small steps. `bound_mm` is an upper bound of its length.
// Returns no points if the bound is too great for a path that can be drawn, or not a number.
template<typename Curve> static std::vector<Vec3> sample(double bound_mm, Curve const& curve)
{
    if (!(bound_mm <= 2 * kLongest_mm))
        return {};
    int const steps = std::max(2, static_cast<int>(std::ceil(bound_mm / kStep_mm)));
    std::vector<Vec3> points;
    for (int i = 0; i <= steps; ++i)
        points.push_back(curve(static_cast<double>(i) / steps));
    return points;
}

static std::vector<Vec3> points_of(LineShape const& line)
{
    return { line.from_mm, line.to_mm };
}

static std::vector<Vec3> points_of(HelixShape const& helix)
{
    double const widest_mm = std::max(std::abs(helix.radius_mm), std::abs(helix.end_radius_mm));
    double const length_mm = 2 * kPi * widest_mm * std::abs(helix.turns) + std::abs(helix.rise_mm)
        + std::abs(helix.end_radius_mm - helix.radius_mm);
    return sample(length_mm, [&](double u) -> Vec3 {
        double const angle = helix.start_rad + 2 * kPi * helix.turns * u;
        double const radius_mm = helix.radius_mm + (helix.end_radius_mm - helix.radius_mm) * u;
        return helix.foot_mm
            + Vec3(radius_mm * std::cos(angle), radius_mm * std::sin(angle), helix.rise_mm * u);
    });
}

static std::vector<Vec3> points_of(SCurveShape const& curve)
{
    Vec3 const way = curve.to_mm - curve.from_mm;
    Vec3 const across(-way.y(), way.x(), 0);
    Vec3 const side = across.norm() > 0 ? across.normalized() : Vec3::UnitX();
    double const length_mm = way.norm() + 2 * kPi * std::abs(curve.swing_mm);
    return sample(length_mm, [&](double u) -> Vec3 {
        return curve.from_mm + u * way + curve.swing_mm * std::sin(2 * kPi * u) * side;
    });
}

static std::vector<Vec3> points_of(BranchShape const& branch)
{
    Vec3 tip = branch.from_mm;
    double before = 0;
    return sample(branch.length_mm, [&](double u) -> Vec3 {
        double const middle = (before + u) / 2;
        double const heading = branch.heading_rad + branch.turn_rad * middle;
        double const elevation = branch.elevation_rad + branch.bend_rad * middle;
        tip += branch.length_mm * (u - before)
            * Vec3(std::cos(elevation) * std::cos(heading), std::cos(elevation) * std::sin(heading),
                   std::sin(elevation));
        before = u;
        return tip;
    });
}

static std::vector<Vec3> const& points_of(PolylineShape const& polyline)
{
    return polyline.points_mm;
}

static std::vector<Vec3> points_of_any(PathShape const& shape)
{
    return std::visit([](auto const& kind) { return std::vector<Vec3>(points_of(kind)); }, shape);
}

bool is_drawable(PathShape const& shape)
{
    double const length_mm = polyline_length_mm(points_of_any(shape));
    // The comparison is also false for NaN and infinity.
    return length_mm > 0 && length_mm <= kLongest_mm;
}

Path make_path(PathShape const& shape)
{
    return Path(points_of_any(shape));
}

} // namespace tractus::sim
