#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::indicators {

// The motion indicators of a plant as arrows (see ListDrawnCurves); empty if the plant has none.
std::vector<tools::DrawnCurve> indicator_curves(scene::BuiltPlant const& plant);

} // namespace tractus::indicators
