#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::lines {

// The construction lines of a plant, and the lines of its leaves in three views. See
// ListDrawnCurves; empty for a plant that is not drawn with construction lines.
std::vector<tools::DrawnCurve> construction_curves(scene::BuiltPlant const& plant);

} // namespace tractus::lines
