#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/branch_tree.h"

#include <vector>

namespace tractus::variation {

// Paths of segments, each from root to tip, to which strokes are applied.
using Selection = std::vector<std::vector<SegmentId>>;

// Returns the path between two segments, given in either order. Fails, in one sentence, if neither
// is a descendant of the other.
Result<std::vector<SegmentId>> path_by_ends(BranchTree const& tree, SegmentId one, SegmentId other);

// Returns all axes of a branching order (0 for trunks), each complete.
Selection axes_of_order(Plant const& plant, std::uint32_t order);

// Returns the axis of a segment and its similar siblings, which have the same parent axis and half
// to twice its length. Each is complete; they are in the plant's order.
Selection similar_siblings(Plant const& plant, SegmentId segment);

// Returns all segments that are not selected, as paths each of which lies on one axis.
Selection inverted(Plant const& plant, Selection const& selection);

// Returns the paths of both selections; a path that is in both is listed once.
Selection added(Selection selection, Selection const& more);

// Returns `selection` without the segments of `less`. A path that loses segments in its middle is
// split.
Selection taken(Selection const& selection, Selection const& less);

} // namespace tractus::variation
