#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/organ_shape.h"

namespace tractus::mesh {

// How texture coordinates are assigned to a surface.
enum class TextureMapping {
    OnBox, // By position in the surface's bounding box: u across, v along the organ.
    // By patch: the sides of the grid of patches are those of the texture. u runs to the right and
    // v along the organ, regardless of the orientation of the patches. Falls back to OnBox if the
    // patches form no grid.
    OnPatches,
};

// Returns the mesh of an organ of Bézier patches (OrganShape::Kind::Surface), in the organ frame.
//
// All patches are divided into the same number of strips in both directions, 1 to 24, growing with
// `subdivision` (MeshOptions) and with the curvature of the patches. Patches that are declared
// neighbours share the vertices of their seam where these coincide, and its normals in any case.
TriangleMesh surface_mesh(OrganShape const& shape, int subdivision,
                          TextureMapping lies = TextureMapping::OnBox);

} // namespace tractus::mesh
