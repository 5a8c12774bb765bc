#pragma once

#include "app/tools/gizmo.h"

namespace tractus::lines {

// Gizmo that shows the positional functions of the active plant's sketch as curves along the stem,
// its base at the bottom. Its columns are, from left to right: inclination and size of the left
// organs, the stem's heading, size and inclination of the right organs; values increase outwards.
// The nodes are in the middle. Inclinations have a handle at each inclination line; sizes have one
// there and half-way between. Dragging a handle bends the drawn lines (bend_lines.h). The minus and
// plus beside a layer change its number of nodes.
extern tools::DrawnGizmoKind const kLineCurves;

} // namespace tractus::lines
