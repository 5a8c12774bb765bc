#include "sim/rig_geometry.h"

#include <cmath>
#include <fmt/core.h>

namespace tractus::sim {

double string_length_mm(RigGeometry const& geometry, double height_mm)
{
    return std::hypot(geometry.string_offset_mm, geometry.string_base_mm + height_mm);
}

double ideal_counts(RigGeometry const& geometry, double height_mm)
{
    return (string_length_mm(geometry, height_mm) - geometry.string_at_zero_counts_mm)
        / geometry.string_per_count_mm;
}

calib::Rig true_rig(RigGeometry const& geometry)
{
    calib::StringHeight const model {
        .mm_per_count = geometry.string_per_count_mm,
        .zero_length_mm = geometry.string_at_zero_counts_mm,
        .offset_mm = geometry.string_offset_mm,
        .base_mm = geometry.string_base_mm,
    };
    return {
        .height_model = model,
        .full_scale_counts = geometry.full_scale_counts,
        .calibrated_min_counts = std::floor(ideal_counts(geometry, 0)),
        .calibrated_max_counts = std::ceil(ideal_counts(geometry, geometry.travel_mm)),
        .tablet_size_mm = geometry.tablet_size_mm,
        .rotation_deg = geometry.rotation_deg,
        .travel_shear = geometry.travel_shear,
        .coil_height_mm = Vec2::Constant(geometry.coil_height_mm),
    };
}

Eigen::Affine3d T_tablet_world(RigGeometry const& geometry)
{
    return calib::T_world_tablet(true_rig(geometry)).inverse(Eigen::Affine);
}

Result<void> check_reach(RigGeometry const& geometry, Path const& path)
{
    constexpr double kMargin_mm = 1;
    auto const T_tablet_world = sim::T_tablet_world(geometry);
    Vec3 const room_mm(geometry.tablet_size_mm.x(), geometry.tablet_size_mm.y(),
                       geometry.travel_mm);
    for (auto const& point : path.points_mm()) {
        Vec3 const place = T_tablet_world * point;
        if ((place.array() < kMargin_mm).any()
            || (place.array() > room_mm.array() - kMargin_mm).any())
            return fail(
                Fault::User,
                fmt::format("the place ({:.1f}, {:.1f}, {:.1f}) mm is out of the rig's reach: "
                            "the tablet is {} x {} mm and travels {} mm up",
                            point.x(), point.y(), point.z(), room_mm.x(), room_mm.y(),
                            room_mm.z()));
    }
    return {};
}

} // namespace tractus::sim
