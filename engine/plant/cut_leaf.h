#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tractus {

// A leaf as a flat shape of few triangles, cut along its outline and midrib so that it can be
// folded and bent, with its position in the picture of its material.
//
// Frame: x to the leaf's right, y from the end of the petiole towards the tip, seen from the upper
// side. The blade has length 1, except for the variation from leaf to leaf; the petiole is not
// included.
struct CutLeaf {
    std::vector<Vec2> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles; // Indices of corners, counter-clockwise.
    // The end of the petiole in the picture, in texture coordinates (v downwards).
    // `length_in_picture`: the leaf's unit length, in texture coordinates too.
    Vec2 stem_in_picture = Vec2::Zero();
    double length_in_picture = 1;
    // Name of the leaf sheet that the leaf was cut from (engine/lsystem/view/leaf_sheet.h).
    // `number`: the leaf's index on that sheet.
    std::string sheet {};
    int number = 0;

    Vec2 in_picture(Vec2 const& place) const
    {
        return stem_in_picture + length_in_picture * Vec2(place.x(), -place.y());
    }
};

// Bounding box of the corners; empty if there are none.
inline Eigen::AlignedBox2d box_of(CutLeaf const& leaf)
{
    Eigen::AlignedBox2d box;
    for (auto const& corner : leaf.corners)
        box.extend(corner);
    return box;
}

} // namespace tractus
