#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::leaf {

// The lines of a drawn leaf (see ListDrawnCurves); empty for a plant that is not a drawn leaf.
std::vector<tools::DrawnCurve> leaf_sketch_curves(scene::BuiltPlant const& plant);

} // namespace tractus::leaf
