#pragma once

#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <span>

namespace tractus {

// The shape of the pen's nib, which determines the width of the displayed ink.
enum class Nib {
    Point, // Draws a line whose width depends only on the pressure, not on the tilt.
    Side,  // Draws like the side of a tilted pencil: a broad line if moved across its tilt.
};

// Returns the factor by which the ink at tip `i` of a stroke is wider than that of a point nib: 1
// for Nib::Point and for tips without tilt. A pencil tilted by less than 30 degrees draws with its
// point. A pencil tilted by 60 degrees or more draws with its whole side, which lies along the
// direction of tilt: a movement across the tilt leaves a line four times as wide as the point's, a
// movement along it a line as wide as the point's, and a vertical movement a line as wide as the
// side is long.
double broadening(Nib nib, std::span<TipSample const> tips, std::size_t i);

} // namespace tractus
