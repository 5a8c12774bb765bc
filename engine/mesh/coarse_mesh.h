#pragma once

#include "engine/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace tractus::mesh {

// Fewer triangles of a mesh, over the same vertices. Made by meshoptimizer, which removes the edges
// that change the surface least.
struct CoarseTriangles {
    std::vector<std::uint32_t> indices;
    float error_mm = 0; // Approximate distance between this surface and the mesh.
};

// Returns a version with as few triangles as an error allows. The mesh must have triangles.
CoarseTriangles coarse_version(TriangleMesh const& mesh, float max_error_mm);

// Returns coarser and coarser versions of an organ's mesh, for views from afar. Their errors grow
// to a tenth of the mesh's largest extent. Empty if the mesh has only few triangles already.
std::vector<CoarseTriangles> coarse_versions(TriangleMesh const& mesh);

// Returns the mesh of coarse_version(), without the vertices that it does not use.
TriangleMesh simplified(TriangleMesh const& mesh, float max_error_mm);

} // namespace tractus::mesh
