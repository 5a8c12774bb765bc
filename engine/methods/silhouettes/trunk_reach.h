#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Length by which a trunk must be extended straight from its tip to belong to a crown that was
// drawn just above it: to 85 % of the way through the crown. No value if the line is not this
// crown's trunk or already has a point inside the crown.
//
// Conditions: the tip is at most 6 mm outside the outline (more than a hand misses by) and at most
// 15 % of the trunk's length, because near a small tree the next one is close, too. Along the
// direction of the trunk's last quarter, the crown begins no farther than twice the tip's distance
// and continues for at least half of its extent in that direction; a trunk that passes beside a
// crown does not point into it.
//
// The outline is as drawn; the trunk has its base first. Both are in millimetres.
std::optional<double> extension_into_crown(std::span<Vec2 const> trunk,
                                           std::vector<Vec2> const& outline);

// Computes the extension for an outline drawn in several strokes.
std::optional<double> extension_into_crown(std::span<Vec2 const> trunk,
                                           std::vector<std::vector<Vec2>> const& strokes);

// Extends a trunk straight on from its tip by the length `by`.
void go_on(std::vector<Vec2>& trunk, double by);

} // namespace tractus::silhouette
