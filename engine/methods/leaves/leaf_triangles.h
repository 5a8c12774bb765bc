#pragma once

#include "engine/methods/leaves/leaf.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// Triangles of a leaf, counter-clockwise as seen from above: n - 2 for each face of n edges.
// Adjacent faces share vertices, so there are no gaps.
struct LeafTriangles {
    std::vector<Vec3> positions;
    std::vector<Vec2> flat; // Position of each vertex in the flat leaf, in the grammar's unit.
    std::vector<std::array<std::uint32_t, 3>> veins;
    std::vector<std::array<std::uint32_t, 3>> limb;
    // Number of limb faces that overlap themselves in the flat leaf, as lobes do that cover each
    // other. These faces are triangulated as fans, so that their triangles overlap, too.
    std::size_t overlapping_faces = 0;
};

// Triangulates a leaf, including its limb if Leaf::fill() has been called.
LeafTriangles triangles_of(Leaf const& leaf);

// Triangulates a flat counter-clockwise polygon into n - 2 triangles of its corners.
std::vector<std::array<std::uint32_t, 3>> cut_polygon(std::span<Vec2 const> corners);

} // namespace tractus::leaf
