#pragma once

#include "engine/methods/leaves/leaf.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// A leaf as triangles: n - 2 for a face of n edges, counter-clockwise seen from above. Faces that
// touch share vertices, so there are no gaps between them.
struct LeafTriangles {
    std::vector<Vec3> positions;
    std::vector<Vec2> flat; // Place of each vertex in the flat leaf, in the grammar's lengths.
    std::vector<std::array<std::uint32_t, 3>> veins;
    std::vector<std::array<std::uint32_t, 3>> limb;
    // Faces of the limb that overlap themselves in the flat leaf, as lobes do that cover each
    // other: they are cut from one corner, so that their triangles overlap, too.
    std::size_t overlapping_faces = 0;
};

// The limb is part of it after Leaf::fill().
LeafTriangles triangles_of(Leaf const& leaf);

// A flat polygon, counter-clockwise, as triangles of its corners: two less than it has.
std::vector<std::array<std::uint32_t, 3>> cut_polygon(std::span<Vec2 const> corners);

} // namespace tractus::leaf
