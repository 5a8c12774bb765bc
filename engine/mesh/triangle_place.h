#pragma once

#include "engine/mesh/mesh.h"

#include <cstddef>
#include <cstdint>

namespace tractus::mesh {

// How many vertices and indices something has, or how many lie before it.
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

// Where triangles are written next: into arrays of a surface, or into a buffer that holds a part of
// them. Writers move it on; whoever hands it out has made room for the extent that was asked for.
struct TrianglePlace {
    Vec3f* position_mm = nullptr;
    Vec3f* normal = nullptr;
    Vec2f* texture = nullptr;
    std::uint32_t* index = nullptr;
    std::uint32_t vertex = 0; // The number that indices give to the next vertex.
};

// The place `at` within a surface's arrays.
inline TrianglePlace place_in(TriangleMesh& mesh, MeshExtent const& at)
{
    return { mesh.positions_mm.data() + at.vertices, mesh.normals.data() + at.vertices,
             mesh.texture_coordinates.data() + at.vertices, mesh.indices.data() + at.indices,
             static_cast<std::uint32_t>(at.vertices) };
}

} // namespace tractus::mesh
