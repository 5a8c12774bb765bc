#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::indicators {

// The motion indicators of a plant, as arrows. See ListDrawnCurves; empty for a plant that was not
// drawn so.
std::vector<tools::DrawnCurve> indicator_curves(scene::BuiltPlant const& plant);

} // namespace tractus::indicators
