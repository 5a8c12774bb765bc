#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/sketch_organ.h"
#include "engine/scene/back_picture.h"

#include <string>

namespace tractus::lines {

constexpr int kLeafPictureLength = 192; // Length of a leaf's picture in pixels, from base to tip.

// Cuts the leaf out of the image behind the sheet. Returns the cut-out as a PNG file in the (s, t)
// coordinates of the leaf's surface (organ_surface.h): the left and right edges are the leaf's
// boundaries, the lower edge is its base. The width is 32 to 192 pixels, in proportion to the
// leaf's width. The image's own opacity is kept. Beyond the image's border, the colours of its edge
// continue. `sheet` places the leaf on the tablet. Equal inputs give equal bytes. Fails with a user
// error if less than half of the leaf is on the image or the image is damaged.
Result<std::string> traced_picture(SketchOrgan const& organ, SheetPlacement const& sheet,
                                   scene::BackPicture const& picture);

} // namespace tractus::lines
