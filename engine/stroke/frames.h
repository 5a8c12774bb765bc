#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus {

// A tangent with a normal and a binormal; the three are orthonormal and right-handed.
struct Frame {
    Vec3 tangent = Vec3::UnitZ();
    Vec3 normal = Vec3::UnitX();

    Vec3 binormal() const { return tangent.cross(normal); }
};

// Returns a unit vector orthogonal to the unit vector `tangent`: the one nearest to +x, so that
// strokes drawn from the front keep their left and right, or nearest to +y if `tangent` is parallel
// to x.
Vec3 any_normal(Vec3 const& tangent);

// Returns the rotation by the smallest angle that takes the unit vector `from` to the unit vector
// `to`. For opposite vectors, where the axis is undetermined: half a turn about any_normal(from).
Quat least_rotation(Vec3 const& from, Vec3 const& to);

// Returns a rotation-minimising frame for each segment of a polyline of at least two points: each
// frame is the previous one, rotated by least_rotation() from direction to direction (discrete
// parallel transport, the limit that Wang et al., "Computation of rotation minimizing frames",
// 2008, approximate). A segment of zero length takes the direction of the segment before it; at the
// beginning, that of the first segment with a length; +z if no segment has one.
//
// `first_normal` need not be exact: it is made orthogonal to the first tangent.
std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points,
                                              Vec3 const& first_normal);
std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points);

// Returns the unit vector along the component of `side` that is orthogonal to the unit vector
// `tangent`, or any_normal() if the two are parallel.
Vec3 normal_towards(Vec3 const& tangent, Vec3 const& side);

} // namespace tractus
