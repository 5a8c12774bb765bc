#pragma once

#include "engine/mesh/mesh.h"

#include <cmath>

namespace tractus::mesh {

// A leaf of 30 mm with a blade of 192 triangles, folded along its midrib and bent downwards.
inline TriangleMesh bent_leaf()
{
    constexpr std::uint32_t kAcross = 8;
    constexpr std::uint32_t kAlong = 12;
    TriangleMesh leaf;
    for (std::uint32_t row = 0; row <= kAlong; ++row)
        for (std::uint32_t column = 0; column <= kAcross; ++column) {
            float const u = static_cast<float>(column) / kAcross;
            float const v = static_cast<float>(row) / kAlong;
            float const x = 20 * (u - 0.5f);
            leaf.positions_mm.emplace_back(x, 30 * v, std::abs(x) * 0.3f - 5 * v * v);
            leaf.normals.emplace_back(Vec3f(-x * 0.03f, v / 3, 1).normalized());
            leaf.texture_coordinates.emplace_back(u, 1 - v);
            if (row == kAlong || column == kAcross)
                continue;
            auto const first = row * (kAcross + 1) + column;
            auto const above = first + kAcross + 1;
            leaf.indices.insert(leaf.indices.end(),
                                { first, first + 1, above, above, first + 1, above + 1 });
        }
    return leaf;
}

} // namespace tractus::mesh
