#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tractus {

// A leaf as a flat shape of few triangles, cut out along its outline and its midrib, so that it can
// be folded and bent, and where it lies in the picture of its material.
//
// x to the leaf's right, y from the stalk's end towards the tip, seen from the upper side. The
// blade is 1 long, but for the variation from leaf to leaf; the stalk is not counted.
struct CutLeaf {
    std::vector<Vec2> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles; // Counter-clockwise.
    // Where the stalk's end is in the picture, in texture coordinates (v downwards), and how far it
    // is there for a length of 1.
    Vec2 stem_in_picture = Vec2::Zero();
    double length_in_picture = 1;
    // The name of the sheet that it is of (engine/lsystem/view/leaf_sheet.h) and its number there.
    std::string sheet {};
    int number = 0;

    Vec2 in_picture(Vec2 const& place) const
    {
        return stem_in_picture + length_in_picture * Vec2(place.x(), -place.y());
    }
};

// The box round the corners; empty without corners.
inline Eigen::AlignedBox2d box_of(CutLeaf const& leaf)
{
    Eigen::AlignedBox2d box;
    for (auto const& corner : leaf.corners)
        box.extend(corner);
    return box;
}

} // namespace tractus
