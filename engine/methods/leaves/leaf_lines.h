#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/leaf_sketch.h"

#include <vector>

namespace tractus::leaf {

// The lines of the leaf that a sketch gives, as its plant has them: the edge, closed, and then each
// vein. On the paper: (x, y, depth) in millimetres, as drawing_of(). Fails, as the user's fault,
// where the lines are no leaf yet, and like build_leaf().
Result<std::vector<std::vector<Vec3>>> lines_of_leaf(LeafSketch const& sketch);

} // namespace tractus::leaf
