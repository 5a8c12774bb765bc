#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// How far a trunk has to go on, straight from its tip, to be the trunk of a crown below which a
// hand has stopped it: to 85 % of the way through the crown, as one that ends in it goes on. No
// value: it is not this crown's trunk, or it has a point inside.
//
// The tip is outside of the outline by at most 6 mm, which is more than a hand misses by that draws
// a trunk towards a crown, or a crown around the end of a trunk, and by at most 15 % of the trunk's
// length, since beside a small tree the distance to the next one is small, too. Straight on from
// its last quarter the crown begins no farther away than twice that, and goes on for at least half
// of its own extent in this direction: a trunk that passes a crown does not point into it.
//
// The outline is as it was drawn, in millimetres as the trunk, base first.
std::optional<double> reach_into_crown(std::span<Vec2 const> trunk,
                                       std::vector<Vec2> const& outline);

// Likewise of an outline that was drawn in several strokes.
std::optional<double> reach_into_crown(std::span<Vec2 const> trunk,
                                       std::vector<std::vector<Vec2>> const& strokes);

// Makes a trunk go on so far.
void go_on(std::vector<Vec2>& trunk, double by);

} // namespace tractus::silhouette
