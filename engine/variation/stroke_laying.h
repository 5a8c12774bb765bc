#pragma once

#include "engine/base/vectors.h"
#include "engine/stroke/resample.h"
#include "engine/variation/association.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::variation {

// The law StrokeLaying::HeadingAndPitch. A stroke is turned about the vertical to the branch's
// heading, and then pitched in the branch's vertical plane until its own direction meets the
// branch's. It is never rolled: what hangs under the stroke hangs under the branch, and left stays
// left. Turning the drawn stroke about the vertical changes nothing; a mirrored stroke is laid
// mirrored.

// A direction and its compass heading. Near the vertical the heading is not that of the direction.
struct Aim {
    Vec3 direction = Vec3::UnitZ(); // Unit vector.
    Vec2 heading = Vec2::UnitX();   // Unit vector in the ground's plane.
};

// The rotation that lays a stroke of the aim `stroke` along a branch of the aim `branch`:
//
//     R = Rz(heading of the branch) * P(pitch of the branch - pitch of the stroke)
//         * Rz(-heading of the stroke)
//
// P pitches +x upwards. The stroke's pitch is measured in the vertical plane of its heading, so a
// start that leans back past the zenith has more than 90 degrees. Where a heading is not that of
// its direction, a least rotation at the end takes the stroke's direction to the branch's exactly.
Quat lay_by_heading(Aim const& stroke, Aim const& branch);

// The aim of a stroke that leads in `direction`, a unit vector. Within 15 degrees of the vertical
// its heading is that of `reach`, the way to its farthest point as the ground sees it; that of +x
// if this is zero.
Aim aim_of_stroke(Vec3 const& direction, Vec2 const& reach);

// The heading of a branch's `direction`, a unit vector. Within 15 degrees of the vertical it is
// blended smoothly into `otherwise`, a unit vector, so that no branch jumps while the plant moves.
Vec2 branch_heading(Vec3 const& direction, Vec2 const& otherwise);

// Within 15 degrees of the vertical.
bool is_upright(Vec3 const& direction);

// From the first point to the one that lies farthest from it as the ground sees it; zero for a
// plumb line.
Vec2 farthest_reach(std::span<Vec3 const> points);

// The share of a curve's length after which it has made its first whole turn, if it makes at least
// one and a half, as a helix does. No value: it does not wind.
std::optional<double> first_turn_share(ArcLength const& curve);

// The share of a stroke's length whose chord is its start, along a chain of segments of these
// lengths: a twentieth, since single samples tremble; what the first segment shows, where that is
// more, but at most a third; and a whole turn of a curve that winds (`first_turn`).
double start_share(std::span<double const> lengths_mm, std::optional<double> first_turn);

// A stroke as a chain of segments shows it.
struct ShownStroke {
    std::vector<Vec3> directions;   // One unit vector per segment, as drawn.
    Vec3 direction = Vec3::UnitZ(); // The stroke's own, by which it is laid; unit vector.
};

// The stroke is followed by arc length. With StrokeFit::Start its direction is that of its first
// `share`; otherwise it leads from the chain's base to its tip. Where the hand turned back on
// itself a segment goes on as the one before.
ShownStroke shown_stroke(ArcLength const& curve, std::span<double const> lengths_mm, StrokeFit fit,
                         double share);

// The direction of a branch, by the same measure: of the first `share` of its length with
// StrokeFit::Start, otherwise from its base to its tip. `frames`, its segments' (RestShape), are as
// many as lengths, at least one.
Vec3 branch_direction(std::span<Quat const> frames, std::span<double const> lengths_mm,
                      StrokeFit fit, double share);

// The heading of a branch's farthest point as the ground sees it; that of +x for a plumb line. The
// branch is turned by `turn`.
Vec2 reach_heading(std::span<Quat const> frames, std::span<double const> lengths_mm,
                   Quat const& turn);

} // namespace tractus::variation
