#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/organ_shape.h"

namespace tractus::mesh {

// How texture coordinates are assigned to a surface.
enum class TextureMapping {
    OnBox, // By the vertex's position in the surface's bounding box: u across, v along the organ.
    // By the vertex's position in the grid that the patches form: the sides of the grid are the
    // edges of the texture. u runs to the right and v along the organ, whatever the orientation of
    // the patches. If the patches form no grid, OnBox is used.
    OnPatches,
};

// Returns the mesh of an organ of Bézier patches (OrganShape::Kind::Surface), in the organ frame.
//
// All patches are divided into the same number of strips in both directions, 1 to 24. The number
// grows with `subdivision` (MeshOptions) and with the curvature of the patches. Patches that are
// declared neighbours share the vertices of their seam where these coincide; their normals agree
// along the whole seam.
TriangleMesh surface_mesh(OrganShape const& shape, int subdivision,
                          TextureMapping lies = TextureMapping::OnBox);

} // namespace tractus::mesh
