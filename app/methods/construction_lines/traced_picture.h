#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/sketch_organ.h"
#include "engine/scene/back_picture.h"

#include <string>

namespace tractus::lines {

constexpr int kLeafPictureLength = 192; // Pixels, from base to tip.

// What of the picture that lies behind the sheet is between the boundaries of a leaf, as a PNG file
// in the (s, t) of its surface (organ_surface.h): its left and right edges are the boundaries, its
// lower edge is the base; 32 to 192 pixels across, by the leaf's breadth. As strong as the picture
// itself is, and transparent where that is; where the leaf lies over an edge of the picture it has
// that edge's colours. `sheet` says where on the tablet the leaf is. The same in, the same bytes
// out. Fails, as the user's fault, where less than half of the leaf lies on the picture, or this is
// damaged.
Result<std::string> traced_picture(SketchOrgan const& organ, SheetPlacement const& sheet,
                                   scene::BackPicture const& picture);

} // namespace tractus::lines
