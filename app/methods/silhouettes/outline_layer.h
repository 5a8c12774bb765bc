#pragma once

#include "app/tools/layer.h"

namespace tractus::silhouette {

// What was drawn of the active tree, where it stands: its crown's outline,
extern tools::Layer const kOutlineLayer;
// and its trunk and branches.
extern tools::Layer const kTrunkLayer;
// What was seen in the crown's outline: each bump's chord and middle, and the parts of the crown
// that branches have. It fades after each change, unless the tool in hand says otherwise.
extern tools::Layer const kSeenLayer;
// The triangles that the bumps are found by, when the tool in hand asks for them.
extern tools::Layer const kTrianglesLayer;

} // namespace tractus::silhouette
