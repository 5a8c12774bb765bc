#pragma once

#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/paint_raster.h"

namespace tractus::leaf {

// Fills the unmarked tiles with the mean colour of the leaf's pixels in the smallest surrounding
// square that has any, so that colours continue to the picture's edge.
void spread_colors(LeafPicture& picture, TileGrid const& tiles);

} // namespace tractus::leaf
