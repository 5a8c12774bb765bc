#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/material.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::mesh {

// One or more closed surfaces, as 3D printers need them. Every edge is shared by exactly two
// triangles, which run along it in opposite directions. Triangles are counter-clockwise as seen
// from outside. Frame and unit are the plant's: millimetres, +z up.
struct ClosedMesh {
    using Triangle = std::array<std::uint32_t, 3>;

    std::vector<Vec3f> positions_mm;
    std::vector<MaterialId> materials; // One per vertex.
    std::vector<Triangle> triangles;   // Indices of vertices.
};

// Appends the surfaces of `other`.
void append(ClosedMesh& mesh, ClosedMesh const& other);

// Gives different vertices different positions: of vertices that coincide, all but the first are
// moved by the least amount that a float knows. So a program that finds a file's edges by the
// positions of their ends, as with STL, finds those of the mesh.
void separate_vertices(ClosedMesh& mesh);

// Number of closed surfaces: of parts that share no vertex.
std::size_t count_surfaces(ClosedMesh const& mesh);

// Removes the surfaces that enclose a hollow, so that it is filled: those whose triangles are
// clockwise as seen from outside.
void fill_hollows(ClosedMesh& mesh);

} // namespace tractus::mesh
