#pragma once

#include "engine/mesh/mesh.h"

#include <cstddef>
#include <cstdint>

namespace tractus::mesh {

// Numbers of vertices and indices: of a part of a mesh, or of all parts before it.
struct MeshExtent {
    std::size_t vertices = 0;
    std::size_t indices = 0;

    MeshExtent& operator+=(MeshExtent const& other)
    {
        vertices += other.vertices;
        indices += other.indices;
        return *this;
    }
};

// Write position in the arrays of a surface, or in a buffer for a part of the surface. The
// functions that write triangles advance it. Their caller must provide room for the MeshExtent that
// was computed beforehand.
struct TrianglePlace {
    Vec3f* position_mm = nullptr;
    Vec3f* normal = nullptr;
    Vec2f* texture = nullptr;
    std::uint32_t* index = nullptr;
    std::uint32_t vertex = 0; // Number of the next vertex, as it appears in the triangles' indices.
};

// Returns the write position after `at` vertices and indices in a surface's arrays.
inline TrianglePlace place_in(TriangleMesh& mesh, MeshExtent const& at)
{
    return { mesh.positions_mm.data() + at.vertices, mesh.normals.data() + at.vertices,
             mesh.texture_coordinates.data() + at.vertices, mesh.indices.data() + at.indices,
             static_cast<std::uint32_t>(at.vertices) };
}

} // namespace tractus::mesh
