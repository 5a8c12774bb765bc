#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::lines {

// The construction lines of a plant, and the lines of its leaves that were drawn in three views
// (see ListDrawnCurves). Empty for a plant that was not drawn with construction lines.
std::vector<tools::DrawnCurve> construction_curves(scene::BuiltPlant const& plant);

} // namespace tractus::lines
