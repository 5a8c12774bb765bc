#pragma once

#include "engine/methods/silhouettes/crown_surface.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Fast test of whether points in space are inside a drawn crown surface. It uses a table of the
// surface's greatest distance from the trunk by height and azimuth.
class SurfaceFit {
public:
    // `from_sheet`: transform from the sheet (x, y, z towards the viewer) to the plant.
    SurfaceFit(CrownSurface const& surface, Eigen::Affine3d const& from_sheet);

    bool holds(Vec3 const& plant_mm) const;

    // Scale, from kMin to 1, by which points must shrink about `about_mm` so that nine of ten are
    // inside.
    static constexpr double kMin = 0.4;
    double size_inside(std::span<Vec3 const> places_mm, Vec3 const& about_mm) const;

private:
    static constexpr std::size_t kAround = 72;
    static constexpr std::size_t kHeights = 65;

    double reach(double theta_rad, double height) const;

    CrownSurface surface_;
    Eigen::Affine3d to_sheet_;
    double low_ = 1e300;
    double high_ = -1e300;
    std::array<std::array<double, kHeights>, kAround> reach_ {};
};

} // namespace tractus::silhouette
