#pragma once

#include "app/tools/gizmo.h"

namespace tractus::sketch {

// Gizmo of a SketchTool's rule, after Ijiri, Owada, Igarashi 2006, figure 3: a parent, its ring of
// laterals and the top internode, each followed by the next ring. Handles set a lateral's angle and
// length (A), the twist of the rings from node to node (B) and the lateral's width (C), and for the
// top its length (D), twist (E) and width (F). Minus and plus change the number of laterals.
extern tools::GizmoKind const kRuleGizmo;

} // namespace tractus::sketch
