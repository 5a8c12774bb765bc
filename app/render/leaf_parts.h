#pragma once

#include "engine/mesh/coarse_mesh.h"
#include "engine/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace tractus::render {

// True for the materials of leaves and petals.
bool is_thin(Material const& material);

// The connected parts of a mesh, such as the leaves of a surface that many leaves were merged into.
struct ConnectedParts {
    std::vector<std::uint32_t> part;   // Number of each vertex's part.
    std::vector<Vec3f> middles_mm;     // Mean position of each part's vertices.
    std::vector<std::uint32_t> counts; // Number of vertices of each part.
};

// Parts are connected by triangles that share a vertex. They are numbered in the order of their
// first vertices.
ConnectedParts connected_parts(mesh::TriangleMesh const& mesh);

// Middle of the part with most vertices: for a leaf that of its blade, not that of its stalk.
// `mesh` must have vertices.
Vec3f middle_of_largest_part(mesh::TriangleMesh const& mesh);

// Coarser and coarser versions of a spray of many small parts, such as the needles of a shoot, for
// views from afar. Each has every second part of the one before, twice as wide, so that the total
// area stays: simplified triangles of thin parts would vanish. The vertices of the wide parts are
// appended to `mesh`. A version's error is the width of its parts. Empty if the mesh has few parts
// or if these have many triangles.
std::vector<mesh::CoarseTriangles> thinned_versions(mesh::TriangleMesh& mesh);

// Two pseudo-random numbers from 0 to 1 by which a leaf differs from the others of its plant. They
// depend on its place only, so that a leaf looks the same whether it is an instance or merged into
// a surface.
Vec2f individual_at(Vec3f const& middle_mm);

} // namespace tractus::render
