#pragma once

#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/paint_raster.h"

namespace tractus::leaf {

// Fills the tiles that are not near the leaf: each with the mean of the leaf's pixels in the
// smallest square round it that has any, so that colours go on to the picture's edge.
void spread_colors(LeafPicture& picture, TileGrid const& tiles);

} // namespace tractus::leaf
