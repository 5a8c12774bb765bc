#pragma once

#include "engine/stroke/tip_sample.h"

#include <cstddef>
#include <span>

namespace tractus {

// The end of a pen, as its ink shows it.
enum class Nib {
    Point, // Leaves a line as wide as the pen was pressed, whichever way it leans.
    Side,  // Leant as a pencil is for shading, it leaves a broad line across its lean.
};

// How many times broader than a point's the ink of tip `i` of a stroke is: 1 for a point, and for
// tips that know no tilt. A pencil that leans by less than 30 degrees draws with its point, one
// that leans by 60 or more with all of its side, which lies along its lean: a movement across the
// lean leaves a line four times as broad, one along the lean a line no broader than the point's,
// and one straight up a wall as broad as the side is long.
double broadening(Nib nib, std::span<TipSample const> tips, std::size_t i);

} // namespace tractus
