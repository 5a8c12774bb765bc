#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus {

// A direction and two sides of it; the three are orthonormal and right-handed.
struct Frame {
    Vec3 tangent = Vec3::UnitZ();
    Vec3 normal = Vec3::UnitX();

    Vec3 binormal() const { return tangent.cross(normal); }
};

// A unit vector at right angles to the unit vector `tangent`: as near to +x as there is, so that
// what is drawn from the front keeps its left and right, or to +y where `tangent` lies along x.
Vec3 any_normal(Vec3 const& tangent);

// The rotation by the least angle that takes the unit vector `from` to the unit vector `to`. Where
// they are opposite, so that the axis is not given: half a turn about any_normal(from).
Quat least_rotation(Vec3 const& from, Vec3 const& to);

// A frame for each segment of a polyline, that turns no more than the segments do: each is the one
// before, rotated by least_rotation from direction to direction (discrete parallel transport, the
// limit that Wang et al., "Computation of rotation minimizing frames", 2008, approximate). At least
// two points. A segment without length takes the direction of the one before it; the first ones,
// that of the first segment that has one; all of them +z, where none has.
//
// `first_normal` needs not be exact: it is made orthogonal to the first tangent.
std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points,
                                              Vec3 const& first_normal);
std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points);

// `side` made orthogonal to the unit vector `tangent`, and a unit vector. any_normal where the two
// are parallel.
Vec3 normal_towards(Vec3 const& tangent, Vec3 const& side);

} // namespace tractus
