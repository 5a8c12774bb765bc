#include "engine/methods/silhouettes/surface_fit.h"

#include <algorithm>
#include <cmath>

namespace tractus::silhouette {

SurfaceFit::SurfaceFit(CrownSurface const& surface, Eigen::Affine3d const& from_sheet)
    : surface_(surface)
    , to_sheet_(from_sheet.inverse())
{
    auto const theta_deg = [](std::size_t i) { return static_cast<double>(i) * 360 / kAround; };
    for (std::size_t i = 0; i < kAround; ++i) {
        Vec2 const range = surface_.heights(theta_deg(i));
        low_ = std::min(low_, range.x());
        high_ = std::max(high_, range.y());
    }
    double const step = (high_ - low_) / (kHeights - 1);
    for (std::size_t i = 0; i < kAround; ++i) {
        auto const section = surface_.section(theta_deg(i));
        for (std::size_t p = 1; p < CrownSurface::kPoints && step > 0; ++p) {
            Vec2 const a = section[p - 1].y() <= section[p].y() ? section[p - 1] : section[p];
            Vec2 const b = section[p - 1].y() <= section[p].y() ? section[p] : section[p - 1];
            auto const first = static_cast<std::size_t>(
                std::clamp(std::ceil((a.y() - low_) / step), 0.0, kHeights - 1.0));
            for (auto h = first; h < kHeights; ++h) {
                double const height = low_ + static_cast<double>(h) * step;
                if (height > b.y())
                    break;
                double const rise = b.y() - a.y();
                double const share = rise > 0 ? (height - a.y()) / rise : 1;
                auto& reach = reach_[i][h];
                reach = std::max(reach, a.x() + share * (b.x() - a.x()));
            }
        }
    }
}

double SurfaceFit::reach(double theta_rad, double height) const
{
    if (height < low_ || height > high_ || !(high_ > low_))
        return 0;
    double const up = (height - low_) / (high_ - low_) * (kHeights - 1);
    auto const h = std::min(static_cast<std::size_t>(up), kHeights - 2);
    double const rest = up - static_cast<double>(h);
    double const turn = theta_rad / (2 * kPi) - std::floor(theta_rad / (2 * kPi));
    double const around = turn * kAround;
    auto const i = static_cast<std::size_t>(around) % kAround;
    double const side = around - std::floor(around);
    auto const at = [&](std::size_t azimuth) {
        return reach_[azimuth][h] + rest * (reach_[azimuth][h + 1] - reach_[azimuth][h]);
    };
    return at(i) + side * (at((i + 1) % kAround) - at(i));
}

bool SurfaceFit::holds(Vec3 const& plant_mm) const
{
    Vec3 const sheet = to_sheet_ * plant_mm;
    Vec3 const at = surface_.to_trunk(Vec3(sheet.x(), sheet.y(), -sheet.z()));
    // Leaves may reach this multiple of the surface's distance from the trunk.
    constexpr double kOver = 1.03;
    return at.head<2>().norm() <= kOver * reach(std::atan2(at.y(), at.x()), at.z());
}

double SurfaceFit::size_inside(std::span<Vec3 const> places_mm, Vec3 const& about_mm) const
{
    auto const fits = [&](double size) {
        std::size_t outside = 0;
        for (auto const& place : places_mm)
            outside += !holds(about_mm + size * (place - about_mm));
        return 10 * outside <= places_mm.size();
    };
    if (fits(1))
        return 1;
    double low = kMin;
    double high = 1;
    for (int i = 0; i < 6; ++i) {
        double const middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

} // namespace tractus::silhouette
