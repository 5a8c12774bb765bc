#pragma once

#include "engine/stroke/frames.h"

#include <cmath>

namespace tractus {

// Returns the frame as the rotation that takes +x to its tangent, +y to its normal and +z to its
// binormal. A rotation needs two thirds of the memory of a Frame, and rotations can be composed.
inline Quat rotation_of(Frame const& frame)
{
    Eigen::Matrix3d columns;
    columns << frame.tangent, frame.normal, frame.binormal();
    return Quat(columns);
}

inline Vec3 tangent_of(Quat const& q)
{
    return { 1 - 2 * (q.y() * q.y() + q.z() * q.z()), 2 * (q.x() * q.y() + q.w() * q.z()),
             2 * (q.x() * q.z() - q.w() * q.y()) };
}

inline Vec3 normal_of(Quat const& q)
{
    return { 2 * (q.x() * q.y() - q.w() * q.z()), 1 - 2 * (q.x() * q.x() + q.z() * q.z()),
             2 * (q.y() * q.z() + q.w() * q.x()) };
}

// Corrects the length of a quaternion whose length differs from 1 only by rounding errors: one
// Newton step, without a square root.
inline Quat renormalised(Quat const& q)
{
    return Quat(q.coeffs() * (1.5 - 0.5 * q.squaredNorm()));
}

// Parallel transport: rotates the frame by the rotation of smallest angle from its tangent `from`
// to the direction `to`. Both are unit vectors.
inline Quat parallel_transport(Quat const& frame, Vec3 const& from, Vec3 const& to)
{
    double const w = 1 + from.dot(to);
    if (w < 1e-14) [[unlikely]]
        return least_rotation(from, to) * frame;
    double const scale = 1 / std::sqrt(2 * w);
    Vec3 const axis = scale * from.cross(to);
    return renormalised(Quat(w * scale, axis.x(), axis.y(), axis.z()) * frame);
}

} // namespace tractus
