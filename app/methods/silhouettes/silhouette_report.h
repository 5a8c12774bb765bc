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
//   samples, triangles, terminal, sleeve, junction   counts of the outline's triangulation
//   bumps         number of bumps
//   bump          for each {"E": [x, y], "r", "tip": [x, y], "tangent": [x, y], "role": "lateral",
//                 "apex" or "foot"}
//   trunk_samples_inside   [first, last] of 64
//   trunk_continues_to     [x, y] or null
//   branch        for each {"name", "t", "side", "base": [x, y], "end": [x, y], "curve": the four
//                 control points of its Bézier curve, "length", "tangent_share", "cone_deg"}. A
//                 branch with an outline of its own also has "outlined": true and "bears", its
//                 number of branches. A branch on which the user drew, or that copies the style of
//                 such a sibling ("follows": true), also has "bearing": {"children": number of its
//                 laterals, "unbranched", "last": shares of the branch's length, "spacing":
//                 {"mean", "deviation"}: millimetres along the branch, "angle_deg": the laterals'
//                 mean angle, "drawn": [{"name", "u", "base", "end"}, …]}. Branches of bumps come
//                 first, then added branches
//   coverage      {"before", "after"}: share of the outline's inside that crowns cover
//   leaf_coverage {"inside": share of the outline that leaves cover, "outside": share of the
//   leaves'
//                 picture that is outside of it}, as seen from the drawing plane in full foliage
//   arrangement   for each level a list of [{"name", "theta", "u"}, …]: degrees around the parent,
//                 0 to the right and 180 to the left, and the place as a share of the parent's
//                 length; deeper levels show the branches of a single parent
//   elements, leaves, branches   counts of the tree
//   notes         guesses, and lines that were ignored
//
// If a surface was drawn in space, also:
//
//   surface       {"rings", "climbs", "sides": how many there are, "radius": for eleven heights,
//                 from lowest to highest, {"height": along the trunk from its base, "at": distances
//                 from the trunk's line every 30 degrees, starting at 0}; null where the surface
//                 does not reach}
//
// If a style was measured on a plant, also the values of this style at each level, as measured on
// that plant and as found in the tree:
//
//   style         {"measured": [level, …], "tree": [level, …]}. A level is {"parents", "children":
//                 {"mean", "deviation"} over parents with children, "bare": share of parents
//                 without children, "unbranched", "spacing": {"mean", "deviation"}, "angle_deg":
//                 {"mean", "first", "last", "deviation"}, "lengths": [low, middle, high],
//                 "pattern"}; all lengths are shares of the parent's
std::string print_report(Skeleton const& skeleton, Tree const& tree,
                         std::optional<MeasuredStyle> const& style = {},
                         std::vector<CrownLine> const& crown_lines = {});

// Report of an arrangement without a drawing: {"pattern", "count", "seed", "cost_before",
// "cost_after", "places": [{"theta", "u"}, …]}.
std::string print_arrangement(Arrangement const& arrangement, Pattern pattern, std::uint64_t seed);

} // namespace tractus::silhouette
