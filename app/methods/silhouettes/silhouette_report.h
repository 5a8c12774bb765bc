#pragma once

#include "engine/methods/silhouettes/crown_line.h"
#include "engine/methods/silhouettes/measured_style.h"
#include "engine/methods/silhouettes/tree.h"

#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

// What was inferred from a drawing, as one line of JSON for other programs; lengths and places in
// the drawing's millimetres:
//
//   samples, triangles, terminal, sleeve, junction   of the outline's triangulation
//   bumps         how many
//   bump          of each {"E": [x, y], "r", "tip": [x, y], "tangent": [x, y], "role": "lateral",
//                 "apex" or "foot"}
//   trunk_samples_inside   [first, last] of 64
//   trunk_continues_to     [x, y] or null
//   branch        of each {"name", "t", "side", "base": [x, y], "end": [x, y], "curve": the four
//                 control points of its Bézier curve, "length", "tangent_share", "cone_deg"}; of
//                 one with an outline of its own also "outlined": true and how many branches that
//                 "bears"; of one that was drawn on, or "follows" such a sibling: true, also
//                 "bearing": {"children": how many, "unbranched", "last": shares of its length,
//                 "spacing": {"mean", "deviation"}: millimetres along it, "angle_deg": their mean,
//                 "drawn": [{"name", "u", "base", "end"}, …]}; those of bumps first, then those
//                 added
//   coverage      {"before", "after"}: shares of the outline's inside that crowns cover
//   arrangement   a list for each level of [{"name", "theta", "u"}, …]: degrees around the parent,
//                 0 to the right and 180 to the left, and the share of its length; those of the
//                 levels below are of one parent
//   elements, leaves, branches   of the tree
//   notes         what had to be guessed or was left out
//
// and with a surface that was drawn in space:
//
//   surface       {"rings", "climbs", "sides": how many there are, "radius": of eleven heights from
//                 its lowest to its highest {"height": along the trunk from its foot, "at":
//                 distances from the trunk's line every 30 degrees, from 0 on}, null where it is
//                 above or below}
//
// and with a style that was measured on a plant, what it is on each level, and what it is in the
// tree:
//
//   style         {"measured": [level, …], "tree": [level, …]}, a level {"parents", "children":
//                 {"mean", "deviation"} of a parent that bears any, "bare": the share of those that
//                 bear none, "unbranched", "spacing": {"mean", "deviation"}, "angle_deg": {"mean",
//                 "first", "last", "deviation"}, "lengths": [low, middle, high], "pattern"}; all
//                 lengths are shares of the parent's
std::string print_report(Skeleton const& skeleton, Tree const& tree,
                         std::optional<MeasuredStyle> const& style = {},
                         std::vector<CrownLine> const& crown_lines = {});

// An arrangement alone: {"pattern", "count", "seed", "cost_before", "cost_after", "places":
// [{"theta", "u"}, …]}.
std::string print_arrangement(Arrangement const& arrangement, Pattern pattern, std::uint64_t seed);

} // namespace tractus::silhouette
