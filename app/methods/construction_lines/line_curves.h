#pragma once

#include "app/tools/gizmo.h"

namespace tractus::lines {

// Gizmo that shows the positional functions of the active plant's sketch as curves along the stem,
// whose base is at the bottom. The columns are, from left to right: inclination and size of the
// left organs, the stem's heading, size and inclination of the right organs. Inclinations and sizes
// increase outwards. The middle column also shows the nodes. Inclinations have a handle at each
// inclination line; sizes have handles at each inclination line and half-way between these.
// Dragging a handle bends the drawn lines (bend_lines.h). The minus and plus beside a layer change
// its number of nodes.
extern tools::DrawnGizmoKind const kLineCurves;

} // namespace tractus::lines
