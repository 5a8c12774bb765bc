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
// branch's. It is never rolled: what droops under the stroke droops under the branch, and left
// stays left. The result does not depend on the heading in which the stroke was drawn; a mirrored
// stroke gives a mirrored result.

// A direction with a heading. Near the vertical the heading is chosen independently of the
// direction.
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
// start that leans back past the zenith has a pitch above 90 degrees. If a heading differs from
// that of its direction, a final least rotation aligns the directions exactly.
Quat lay_by_heading(Aim const& stroke, Aim const& branch);

// Returns the aim of a stroke with the unit vector `direction`. Within 15 degrees of the vertical
// its heading is that of `reach`, the horizontal vector to its farthest point; +x if this is zero.
Aim aim_of_stroke(Vec3 const& direction, Vec2 const& reach);

// Returns the heading of a branch with the unit vector `direction`. Within 15 degrees of the
// vertical it is blended smoothly into the unit vector `otherwise`, so that no branch jumps while
// the plant moves.
Vec2 branch_heading(Vec3 const& direction, Vec2 const& otherwise);

// True within 15 degrees of the vertical, up or down.
bool is_upright(Vec3 const& direction);

// Horizontal vector from the first point to the one at the greatest horizontal distance; zero for a
// vertical line.
Vec2 farthest_reach(std::span<Vec3 const> points);

// Share of a curve's length after which it has completed its first turn, if it makes at least one
// and a half, like a helix. No value if it does not.
std::optional<double> first_turn_share(ArcLength const& curve);

// Share of a stroke's length that counts as its start, for a chain of segments of these lengths:
// one twentieth, since single samples are noisy; the share covered by the first segment if that is
// more, but at most a third; and one full turn for a helical curve (`first_turn`).
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

// Returns the direction of a branch by the same measure: of the first `share` of its length with
// StrokeFit::Start, otherwise from its base to its tip. `frames`: those of its segments
// (RestShape), as many as `lengths_mm`, at least one.
Vec3 branch_direction(std::span<Quat const> frames, std::span<double const> lengths_mm,
                      StrokeFit fit, double share);

// Returns the heading of the point of a branch at the greatest horizontal distance, after rotation
// by `turn`; +x for a vertical branch.
Vec2 reach_heading(std::span<Quat const> frames, std::span<double const> lengths_mm,
                   Quat const& turn);

} // namespace tractus::variation
