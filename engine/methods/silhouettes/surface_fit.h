#pragma once

#include "engine/methods/silhouettes/crown_surface.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Says of places in space whether they lie inside a crown's surface that was drawn, fast: by its
// farthest reach at heights and azimuths.
class SurfaceFit {
public:
    // `from_sheet` takes the sheet (x, y, towards who looks) to the plant.
    SurfaceFit(CrownSurface const& surface, Eigen::Affine3d const& from_sheet);

    bool holds(Vec3 const& plant_mm) const;

    // How large what has these places may be, shrunk about a point, that nine of ten are inside: 1
    // or less, kLeast at least.
    static constexpr double kLeast = 0.4;
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
