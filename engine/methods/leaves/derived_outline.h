#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/flat_line.h"

#include <vector>

namespace tractus::leaf {

// Returns the outline of the leaf that a drawn leaf's grammar derives without variation: closed,
// counter-clockwise from the end of the petiole at (0, 0), in units of the blade's length. Fails if
// the leaf cannot be derived.
Result<FlatLine> derived_outline(DrawnLeaf const& leaf);

// Like derived_outline(), for a compound leaf: the outlines of its leaflets, in units of the
// longest leaflet's length. The petiole begins at (0, 0) and points to (0, 1).
Result<std::vector<FlatLine>> derived_leaflets(DrawnLeaf const& leaf);

} // namespace tractus::leaf
