#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <span>
#include <vector>

namespace tractus::sketch {

// For each lateral of a drawn axis, the share of its length for which it has room, if laterals give
// way (Rule::occupancy_radius_mm): 1 for the full length, 0 if the lateral does not grow. Ordered
// by the axis's nodes, from the second one on, and at each node by the laterals around it.
//
// The space around the axis is divided among its nodes. A lateral, with all that it bears, stays on
// its own node's side of the plane midway to each node of another part of the axis, at least half
// the occupancy radius from that plane (Palubicki et al. 2009 remove the markers within that radius
// of a bud). Two nodes are on different parts if the axis turns back between them; laterals of one
// part may overlap.
std::vector<double> lateral_room(Rule const& rule, std::span<Vec3 const> nodes_mm,
                                 std::vector<Turn> const& turns);

} // namespace tractus::sketch
