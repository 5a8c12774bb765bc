#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus {

// A unit tangent with a unit normal; with the binormal they are orthogonal and right-handed.
struct Frame {
    Vec3 tangent = Vec3::UnitZ();
    Vec3 normal = Vec3::UnitX();

    Vec3 binormal() const { return tangent.cross(normal); }
};

// Returns a unit vector orthogonal to the unit vector `tangent`: the one nearest to +x, so that
// strokes drawn from the front keep their left and right. If `tangent` is within 26 degrees of the
// x axis, returns the one nearest to +y instead.
Vec3 any_normal(Vec3 const& tangent);

// Returns the rotation by the smallest angle that takes the unit vector `from` to the unit vector
// `to`. For opposite vectors, whose rotation axis is undetermined, returns half a turn about
// any_normal(from).
Quat least_rotation(Vec3 const& from, Vec3 const& to);

// Returns a rotation-minimising frame for each segment of a polyline of at least two points. Each
// frame is the previous one, rotated by least_rotation() between the segments' directions (discrete
// parallel transport, the limit that Wang et al., "Computation of rotation minimizing frames",
// 2008, approximate). A segment of zero length has the direction of the segment before it or, at
// the beginning of the polyline, that of the first segment with a length. If no segment has a
// length, all directions are +z.
//
// `first_normal` need not be orthogonal to the first tangent: it is made so.
std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points,
                                              Vec3 const& first_normal);
std::vector<Frame> rotation_minimising_frames(std::span<Vec3 const> points);

// Returns the unit vector along the component of `side` that is orthogonal to the unit vector
// `tangent`, or any_normal() if the two are parallel.
Vec3 normal_towards(Vec3 const& tangent, Vec3 const& side);

} // namespace tractus
