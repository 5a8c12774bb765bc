#pragma once

#include "app/tools/tool.h"
#include "app/view/window_model.h"
#include "engine/stroke/nib.h"
#include "engine/stroke/tip_sample.h"

#include <vector>

namespace tractus::view {

// The ink of a tool's stroke, a point for each tip: as wide as the pressure and the nib say, or as
// what it erases.
InkLine ink_line(std::vector<TipSample> const& tips, tools::Tool const& tool, Nib nib = Nib::Point);

// How far thinned() moves a line or changes its width, at most: a small part of a pixel.
inline constexpr double kThinned_mm = 0.05;

// The same line with as few of its points as that allows, of which the first and the last are two.
InkLine thinned(InkLine const& line);

} // namespace tractus::view
