#pragma once

#include "app/tools/layer.h"

namespace tractus::silhouette {

// Layer of the outlines drawn for the active tree. The layers of this file show lines where the
// plant's sheet is in the world.
extern tools::Layer const kOutlineLayer;
// Layer of the trunk and the branches drawn for the active tree.
extern tools::Layer const kTrunkLayer;
// Layer of what was recognised in the crown's outline: the chord and the centre of each bump, and
// the parts of the crown that belong to branches. The layer is hidden some seconds after each
// change, unless the selected tool asks for it.
extern tools::Layer const kSeenLayer;
// Layer of the triangulation with which bumps are found; shown only if the selected tool asks for
// it.
extern tools::Layer const kTrianglesLayer;

} // namespace tractus::silhouette
