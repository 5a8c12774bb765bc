#include "calib/rig.h"

#include <algorithm>

namespace tractus::calib {

std::optional<HeightRange> calibrated_heights(Rig const& rig)
{
    auto const one = height_mm(rig.height_model, rig.calibrated_min_counts);
    auto const other = height_mm(rig.height_model, rig.calibrated_max_counts);
    if (!one || !other)
        return std::nullopt;
    return HeightRange { .low_mm = std::min(*one, *other), .high_mm = std::max(*one, *other) };
}

Eigen::Affine3d T_world_tablet(Rig const& rig)
{
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    linear.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(radians(rig.rotation_deg)).toRotationMatrix();
    linear.topRightCorner<2, 1>() = rig.travel_shear;

    Vec3 const centre_mm(rig.tablet_size_mm.x() / 2, rig.tablet_size_mm.y() / 2, 0);
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.linear() = linear;
    transform.translation() = -(linear * centre_mm);
    return transform;
}

} // namespace tractus::calib
