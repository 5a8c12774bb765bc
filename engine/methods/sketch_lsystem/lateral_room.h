#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"
#include "engine/methods/sketch_lsystem/rule.h"

#include <span>
#include <vector>

namespace tractus::sketch {

// How much of its length each lateral of a drawn axis has room for, where laterals give way
// (Rule::occupancy_radius_mm): 1 for all of it, 0 for a lateral that does not grow. In the order of
// the nodes from the axis's second on, and of the laterals around each.
//
// The space around the axis is divided among its nodes: a lateral, with all that it bears, stays
// nearer to its own node than to any node of another part of the axis, by half the occupancy radius
// (Palubicki et al. 2009 remove the markers within that radius of a bud). Parts are other parts
// where the axis has turned back between them; along a part laterals overlap as they always did.
std::vector<double> lateral_room(Rule const& rule, std::span<Vec3 const> nodes_mm,
                                 std::vector<Turn> const& turns);

} // namespace tractus::sketch
