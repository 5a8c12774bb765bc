#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::sketch {

// The stroke along which a plant has grown by a rule or a model, at the plant's present size (see
// ListDrawnCurves). Empty for a plant that did not grow along a stroke.
std::vector<tools::DrawnCurve> sketched_curves(scene::BuiltPlant const& plant);

} // namespace tractus::sketch
