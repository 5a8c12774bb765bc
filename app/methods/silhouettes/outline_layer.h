#pragma once

#include "app/tools/layer.h"

namespace tractus::silhouette {

// Layer of the outlines drawn for the active tree. Layers of a drawing show its lines on the
// plant's sheet in the world.
extern tools::Layer const kOutlineLayer;
// Layer of the drawn trunk and branches.
extern tools::Layer const kTrunkLayer;
// Layer of what was recognised in the crown's outline: each bump's chord and centre, and the parts
// of the crown that belong to branches. It fades after each change, unless the selected tool keeps
// it.
extern tools::Layer const kSeenLayer;
// Layer of the triangulation by which bumps are found; shown only if the selected tool asks for it.
extern tools::Layer const kTrianglesLayer;

} // namespace tractus::silhouette
