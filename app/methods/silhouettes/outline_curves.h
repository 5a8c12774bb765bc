#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::silhouette {

// The trunk, the outlines, the branches and the lines in space that were drawn for a tree (see
// ListDrawnCurves). Empty for a plant that was not drawn by its outline.
std::vector<tools::DrawnCurve> outline_curves(scene::BuiltPlant const& plant);

} // namespace tractus::silhouette
