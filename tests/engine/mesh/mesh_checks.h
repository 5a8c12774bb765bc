#pragma once

#include "engine/mesh/mesh.h"

#include <array>
#include <gtest/gtest.h>
#include <map>
#include <utility>

namespace tractus::mesh {

// Expects a valid mesh: its indices are in range, its arrays have equal sizes, its numbers are
// finite, and its normals have unit length.
inline void expect_sound(TriangleMesh const& mesh)
{
    ASSERT_EQ(mesh.normals.size(), mesh.positions_mm.size());
    ASSERT_EQ(mesh.texture_coordinates.size(), mesh.positions_mm.size());
    ASSERT_EQ(mesh.indices.size() % 3, 0u);
    std::size_t wrong = 0;
    for (auto const& position : mesh.positions_mm)
        wrong += position.allFinite() ? 0 : 1;
    for (auto const& normal : mesh.normals)
        wrong += std::abs(normal.norm() - 1) < 1e-4f ? 0 : 1;
    for (auto const& texture : mesh.texture_coordinates)
        wrong += texture.allFinite() ? 0 : 1;
    for (auto const index : mesh.indices)
        wrong += index < mesh.positions_mm.size() ? 0 : 1;
    EXPECT_EQ(wrong, 0u);
}

// Returns the front normal of a triangle, with a length of twice the triangle's area.
inline Vec3 area_vector(TriangleMesh const& mesh, std::size_t triangle)
{
    auto const corner = [&](std::size_t k) -> Vec3 {
        return mesh.positions_mm[mesh.indices[3 * triangle + k]].cast<double>();
    };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

// Returns the number of triangles whose front faces against the normals at their corners.
inline std::size_t inside_out_count(TriangleMesh const& mesh)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
        Vec3f normal = Vec3f::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            normal += mesh.normals[mesh.indices[3 * i + k]];
        Vec3 const area = area_vector(mesh, i);
        count += area.dot(normal.cast<double>()) < -1e-6 * area.norm() ? 1 : 0;
    }
    return count;
}

// Returns the number of edges that are not shared by exactly two triangles in opposite directions.
// Vertices at the same position count as one. The number is 0 for a closed surface.
inline std::size_t open_edge_count(TriangleMesh const& mesh)
{
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> edges;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            auto const& from = mesh.positions_mm[mesh.indices[i + k]];
            auto const& to = mesh.positions_mm[mesh.indices[i + (k + 1) % 3]];
            Place const a { from.x(), from.y(), from.z() };
            Place const b { to.x(), to.y(), to.z() };
            if (a != b)
                edges[a < b ? std::pair(a, b) : std::pair(b, a)] += a < b ? 1 : -1;
        }
    std::size_t count = 0;
    for (auto const& [edge, balance] : edges)
        count += balance == 0 ? 0 : 1;
    return count;
}

// Returns the volume within a closed surface, which is positive if its triangles face outwards.
inline double volume_mm3(TriangleMesh const& mesh)
{
    double volume = 0;
    for (std::size_t i = 0; i < mesh.triangle_count(); ++i)
        volume
            += area_vector(mesh, i).dot(mesh.positions_mm[mesh.indices[3 * i]].cast<double>()) / 6;
    return volume;
}

// True if all arrays of the two meshes are equal, byte by byte.
inline bool same_triangles(TriangleMesh const& a, TriangleMesh const& b)
{
    return a.material == b.material && a.positions_mm == b.positions_mm && a.normals == b.normals
        && a.texture_coordinates == b.texture_coordinates && a.indices == b.indices;
}

} // namespace tractus::mesh
