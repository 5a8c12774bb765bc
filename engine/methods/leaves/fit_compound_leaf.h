#pragma once

#include "engine/methods/leaves/drawn_leaf.h"

namespace tractus::leaf {

// fit_leaf() for a compound leaf.
Result<LeafFit> fit_compound_leaf(RecognisedLeaf const& drawn);

} // namespace tractus::leaf
