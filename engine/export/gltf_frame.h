#pragma once

#include "engine/mesh/mesh.h"

namespace tractus::exports {

// Conversions between our frame (millimetres, +z up) and glTF's (metres, +y up): x is unchanged,
// our z becomes y, our -y becomes z. This is a rotation, so the orientation of triangles is
// preserved.

template<typename Scalar>
Eigen::Matrix<Scalar, 3, 1> turn_to_gltf(Eigen::Matrix<Scalar, 3, 1> const& v)
{
    return { v.x(), v.z(), -v.y() };
}

template<typename Scalar>
Eigen::Matrix<Scalar, 3, 1> turn_from_gltf(Eigen::Matrix<Scalar, 3, 1> const& v)
{
    return { v.x(), -v.z(), v.y() };
}

template<typename Scalar>
Eigen::Matrix<Scalar, 3, 1> to_gltf(Eigen::Matrix<Scalar, 3, 1> const& position_mm)
{
    return turn_to_gltf(position_mm) * Scalar(0.001);
}

template<typename Scalar>
Eigen::Matrix<Scalar, 3, 1> from_gltf(Eigen::Matrix<Scalar, 3, 1> const& position_m)
{
    return turn_from_gltf(position_m) * Scalar(1000);
}

// Converts an instance to glTF's frame; its prototype must be converted, too. The translation of
// the result is in metres.
inline mesh::InstanceTransform to_gltf(mesh::InstanceTransform const& instance)
{
    auto const& r = instance.rotation;
    auto const& s = instance.scale;
    return { to_gltf(instance.translation_mm),
             Quatf(r.w(), r.x(), r.z(), -r.y()).normalized(),
             { s.x(), s.z(), s.y() } };
}

// Converts an instance from glTF's frame: the inverse of to_gltf().
inline mesh::InstanceTransform from_gltf(mesh::InstanceTransform const& instance)
{
    auto const& r = instance.rotation;
    auto const& s = instance.scale;
    return { from_gltf(instance.translation_mm),
             Quatf(r.w(), r.x(), -r.z(), r.y()).normalized(),
             { s.x(), s.z(), s.y() } };
}

} // namespace tractus::exports
