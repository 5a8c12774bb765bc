#pragma once

#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/paint_raster.h"

namespace tractus::leaf {

// Fills each tile outside the leaf (not TileGrid::is_near()) with a mean colour of the leaf, so
// that colours continue to the picture's edge. The mean is over the smallest surrounding square of
// tiles that contains pixels of the leaf.
void spread_colors(LeafPicture& picture, TileGrid const& tiles);

} // namespace tractus::leaf
