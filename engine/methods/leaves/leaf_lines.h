#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_sketch.h"

#include <vector>

namespace tractus::leaf {

// Returns the lines of the leaf that is built from a sketch: first the closed outline, then each
// vein, on the paper as (x, y, depth) in millimetres (drawing_of()). Fails with a user error if the
// sketch's lines do not form a leaf yet, and like build_leaf().
Result<std::vector<std::vector<Vec3>>> lines_of_leaf(LeafSketch const& sketch);

} // namespace tractus::leaf
