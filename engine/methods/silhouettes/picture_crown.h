#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <vector>

namespace tractus::silhouette {

// A downscaled picture: rows from top to bottom, pixels from left to right, red, green and blue
// from 0 to 1 (sRGB).
struct PictureGrid {
    int width = 0;
    int height = 0;
    std::vector<Vec3f> pixels {};

    Vec3f const& at(int x, int y) const
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                      + static_cast<std::size_t>(x)];
    }
};

// Width in pixels at which a crown is segmented. At a finer resolution, leaves and the gaps between
// them would show.
constexpr int kPictureGridWidth = 360;

// Outline of the crown around a point in a picture, counter-clockwise, in pixels with x to the
// right and y up from the lower left corner. A region of similar colour is grown from the point
// while it grows slowly; where its size jumps it has leaked into something else. The threshold with
// the most stable boundary is taken (Matas et al., "Robust wide baseline stereo from maximally
// stable extremal regions", 2002, applied to colour distance). Holes, thin parts and pixel corners
// are removed.
//
// Fails with a user error if no region is distinct, as in sky or ground, or if the crown is cut off
// by two sides of the picture.
Result<std::vector<Vec2>> find_crown_in_picture(PictureGrid const& picture, Vec2 const& place);

} // namespace tractus::silhouette
