#pragma once

#include "app/tools/tool.h"
#include "app/view/window_model.h"
#include "engine/stroke/nib.h"
#include "engine/stroke/tip_sample.h"

#include <vector>

namespace tractus::view {

// Returns the ink of a tool's stroke, with one point per tip. The width of the ink follows the
// pressure and the nib, or the eraser's size.
InkLine ink_line(std::vector<TipSample> const& tips, tools::Tool const& tool, Nib nib = Nib::Point);

// Tolerance of thinned(), for positions and widths: a small fraction of a pixel.
inline constexpr double kThinned_mm = 0.05;

// Simplifies the line within the tolerance kThinned_mm. The first and last points are kept.
InkLine thinned(InkLine const& line);

} // namespace tractus::view
