#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/flat_line.h"

namespace tractus::leaf {

// The outline of the leaf that a drawn leaf's grammar derives to, without variation: closed,
// counter-clockwise from the stalk's end, which is (0, 0), in the blade's lengths. Fails where the
// leaf cannot be derived.
Result<FlatLine> derived_outline(DrawnLeaf const& leaf);

} // namespace tractus::leaf
