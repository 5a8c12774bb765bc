#include "engine/methods/leaves/drawing_plane.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace tractus::leaf {

DrawingPlane::DrawingPlane(std::vector<std::vector<Vec3>> const& lines)
{
    double count = 0;
    for (auto const& line : lines)
        for (auto const& point : line) {
            center += point;
            ++count;
        }
    center /= count;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (auto const& line : lines)
        for (auto const& point : line)
            spread += (point - center) * (point - center).transpose();
    normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
    constexpr double kUpright = 0.2;
    bool const is_upright = std::abs(normal.z()) < kUpright;
    if (is_upright ? normal.y() > 0 : normal.z() < 0) // The viewer is on the side of -y.
        normal = -normal;
    Vec3 const rough = std::abs(normal.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    up = normal.cross(rough).normalized();
    right = up.cross(normal);
}

} // namespace tractus::leaf
