#pragma once

#include "engine/base/vectors.h"
#include "engine/stroke/resample.h"
#include "engine/variation/association.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::variation {

// Implements StrokeLaying::HeadingAndPitch. A stroke is rotated about the vertical to the branch's
// heading, then pitched in the branch's vertical plane until its direction agrees with the
// branch's. It is never rolled: a stroke that bends downwards bends every branch downwards, and a
// bend to the left stays one to the left. The result does not depend on the heading in which the
// stroke was drawn; a mirrored stroke gives a mirrored result.

// A direction with a heading. For a direction near the vertical, which has no clear heading of its
// own, the heading is chosen independently.
struct Aim {
    Vec3 direction = Vec3::UnitZ(); // Unit vector.
    Vec2 heading = Vec2::UnitX();   // Unit vector in the horizontal plane.
};

// Returns the rotation that aligns a stroke with the aim `stroke` to a branch with the aim
// `branch`:
//
//    R = Rz(heading of the branch) * P(pitch of the branch - pitch of the stroke)
//        * Rz(-heading of the stroke)
//
// P pitches +x upwards. The stroke's pitch is measured in the vertical plane of its heading, so a
// start that leans back past the zenith has a pitch above 90 degrees. If the heading of an Aim is
// not that of its direction, a final least rotation aligns the two directions exactly.
Quat lay_by_heading(Aim const& stroke, Aim const& branch);

// Returns the aim of a stroke with the unit vector `direction`. If that is within 15 degrees of the
// vertical, the heading is that of `reach`, the horizontal vector to the stroke's farthest point
// (farthest_reach()), or +x if `reach` is zero.
Aim aim_of_stroke(Vec3 const& direction, Vec2 const& reach);

// Returns the heading of a branch with the unit vector `direction`. Within 15 degrees of the
// vertical the heading is blended smoothly into the unit vector `otherwise`, so that no branch
// jumps while the plant moves.
Vec2 branch_heading(Vec3 const& direction, Vec2 const& otherwise);

// True if `direction` is within 15 degrees of the vertical, up or down.
bool is_upright(Vec3 const& direction);

// Horizontal vector from the first point to the point at the greatest horizontal distance from it;
// zero for a vertical line.
Vec2 farthest_reach(std::span<Vec3 const> points);

// Share of a curve's length after which it has completed its first full turn, if it makes at least
// one and a half turns, like a helix. No value for other curves.
std::optional<double> first_turn_share(ArcLength const& curve);

// Share of a stroke's length that counts as its start, for a chain of segments of these lengths.
// For a helical curve it is one full turn (`first_turn`). Otherwise it is the share of the first
// segment, but at least a twentieth, since single samples are noisy, and at most a third.
double start_share(std::span<double const> lengths_mm, std::optional<double> first_turn);

// A stroke sampled by a chain of segments.
struct SampledStroke {
    std::vector<Vec3> directions;   // One unit vector per segment, as drawn.
    Vec3 direction = Vec3::UnitZ(); // Unit vector: the direction by which the stroke is aligned.
};

// Samples the stroke by arc length. With StrokeFit::Start its direction is that of its first
// `share`; otherwise it is its chord. If the stroke turns back on itself, a segment takes the
// direction of the one before.
SampledStroke sample_stroke(ArcLength const& curve, std::span<double const> lengths_mm,
                            StrokeFit fit, double share);

// Returns the direction of a branch, to be compared with SampledStroke::direction: that of the
// first `share` of its length with StrokeFit::Start, otherwise that from its base to its tip.
// `frames` and `lengths_mm`: those of its segments (RestShape); at least one segment.
Vec3 branch_direction(std::span<Quat const> frames, std::span<double const> lengths_mm,
                      StrokeFit fit, double share);

// Returns the heading from the base of a branch, rotated by `turn`, to its point at the greatest
// horizontal distance from the base; +x for a vertical branch.
Vec2 reach_heading(std::span<Quat const> frames, std::span<double const> lengths_mm,
                   Quat const& turn);

} // namespace tractus::variation
