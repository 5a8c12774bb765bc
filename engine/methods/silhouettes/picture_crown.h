#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <vector>

namespace tractus::silhouette {

// A small picture: rows from top to bottom, pixels from left to right, red, green and blue from 0
// to 1 as people write them (sRGB).
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

// As wide a picture as a crown is looked for in: finer, leaves and gaps between them would count.
constexpr int kPictureGridWidth = 360;

// The outline of the crown that a place in a picture lies in, counter-clockwise in pixels, x to the
// right and y up from the lower left corner. What looks like the place grows from there as long as
// it grows little, since where it jumps it has flowed over into something else; it is kept where
// its edge is steadiest (Matas et al., "Robust wide baseline stereo from maximally stable extremal
// regions", 2002, of distances in colour). Without holes, thin parts and corners of pixels.
//
// Fails, as the user's fault, where nothing stands out: sky, ground, a crown that is cut off by
// two sides of the picture.
Result<std::vector<Vec2>> crown_in_picture(PictureGrid const& picture, Vec2 const& place);

} // namespace tractus::silhouette
