#pragma once

#include "app/tools/drawn_curve.h"

#include <vector>

namespace tractus::self_organising {

// The strokes of the growth brush along which a tree has grown (see ListDrawnCurves). Empty for a
// plant that was not grown with the brush.
std::vector<tools::DrawnCurve> growth_brush_curves(scene::BuiltPlant const& plant);

} // namespace tractus::self_organising
