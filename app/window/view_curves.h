#pragma once

#include "app/render/curve.h"
#include "app/window/window_model.h"

#include <vector>

// What the views draw, as curves. Values in, values out: no window needed.
namespace tractus {

// The drawing pad's picture: a grid at the surface, the volume below it, ink and strokes that grow
// paler with the depth below the surface, the skeleton faintly, the pen's tip and its drop line.
std::vector<Curve> pad_curves(WindowState const& state);

// The skeleton with its states, the indicators, and a ring on the ground.
std::vector<Curve> skeleton_curves(WindowState const& state);

} // namespace tractus
