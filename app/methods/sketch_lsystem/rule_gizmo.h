#pragma once

#include "app/tools/gizmo.h"

namespace tractus::sketch {

// Gizmo of a SketchTool's rule, after Ijiri, Owada, Igarashi 2006, figure 3. It shows a parent
// branch, the ring of laterals at its end, and the top internode. At the end of each lateral and of
// the top internode is the next ring. Handles set a lateral's angle and length (A), the twist of
// its rings from node to node (B) and its width (C). Others set the top internode's length (D),
// twist (E) and width (F). Minus and plus change the number of laterals.
extern tools::GizmoKind const kRuleGizmo;

} // namespace tractus::sketch
