#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/flat_line.h"

namespace tractus::leaf {

// Returns the outline of the leaf that a drawn leaf's grammar derives without variation: closed,
// counter-clockwise from the end of the petiole at (0, 0), in units of the blade's length. Fails if
// the leaf cannot be derived.
Result<FlatLine> derived_outline(DrawnLeaf const& leaf);

} // namespace tractus::leaf
