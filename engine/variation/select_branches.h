#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/branch_tree.h"

#include <vector>

namespace tractus::variation {

// Paths of segments, each from root to tip: what strokes go to.
using Selection = std::vector<std::vector<SegmentId>>;

// The long path that has its two ends in these segments, in either order, and everything between.
// Refuses, in a sentence, ends of which neither stands on the other.
Result<std::vector<SegmentId>> path_by_ends(BranchTree const& tree, SegmentId one, SegmentId other);

// Every axis of an order, 0 for the trunk; each whole.
Selection axes_of_order(Plant const& plant, std::uint32_t order);

// The axis of a segment and its siblings that are like it: those that the same axis bears and that
// are half to twice as long. Each whole, in the plant's order.
Selection siblings_alike(Plant const& plant, SegmentId segment);

// Everything that is not selected, as paths along one axis each.
Selection inverted(Plant const& plant, Selection const& selection);

// `selection` and besides it `more`; what it has already is not added again.
Selection added(Selection selection, Selection const& more);

// `selection` without the segments of `less`. A path that loses some in its middle falls into two.
Selection taken(Selection const& selection, Selection const& less);

} // namespace tractus::variation
