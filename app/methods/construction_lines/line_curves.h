#pragma once

#include "app/tools/glyph.h"

namespace tractus::lines {

// The positional functions of the active plant's sketch as curves, the stem from below to above:
// from left to right the inclination and the size of what grows on the left, the stem's direction,
// the size and the inclination on the right, each outwards; in the middle the nodes. A handle on an
// inclination is at each inclination line, one on a size there and half way between; the lines
// follow them (bend_lines.h). Minus and plus beside a layer change how many nodes it has.
extern tools::DrawnGlyphKind const kLineCurves;

} // namespace tractus::lines
