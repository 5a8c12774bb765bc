#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::sketch {

// The stroke along which a rule or a model has grown, at the size of its plant. See
// ListDrawnCurves; empty for a plant that did not grow along a stroke.
std::vector<tools::DrawnCurve> sketched_curves(scene::BuiltPlant const& plant);

} // namespace tractus::sketch
