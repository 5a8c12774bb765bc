#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tractus {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Quat = Eigen::Quaterniond;

// Single precision, for bulk data that is sent to a graphics card or a file.
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Quatf = Eigen::Quaternionf;

constexpr double kPi = 3.14159265358979323846;

constexpr double radians(double degrees)
{
    return degrees * (kPi / 180.0);
}

constexpr double degrees(double radians)
{
    return radians * (180.0 / kPi);
}

// Returns the rotation from the direction of `from` to the direction of `to`, both non-zero
// (Eigen's FromTwoVectors). Compiled in one place since it contains a matrix decomposition. For
// unit vectors use least_rotation() (engine/stroke/frames.h), which needs no decomposition.
Quat rotation_between(Vec3 const& from, Vec3 const& to);

} // namespace tractus
