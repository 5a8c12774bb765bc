#include "calib/rig.h"

namespace tractus {

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

} // namespace tractus
