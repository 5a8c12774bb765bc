#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/organ_shape.h"

namespace tractus::mesh {

// How the texture lies on a surface.
enum class TextureLies {
    OnBox, // On the surface's box: u across it, v along the organ.
    // On the patches, where these are a grid: their sides are the texture's. u goes to the right
    // and v along the organ, whatever way the patches go. On the box where they are no grid.
    OnPatches,
};

// The triangles of an organ of Bézier patches (OrganShape::Kind::Surface), in the organ frame.
//
// All patches are cut into the same number of strips both ways, more for a finer `subdivision`
// (MeshOptions) and for patches that bend more: 1 to 24. Patches that are named as neighbours share
// the vertices of their seam where these coincide, and its normals in any case.
TriangleMesh surface_mesh(OrganShape const& shape, int subdivision,
                          TextureLies lies = TextureLies::OnBox);

} // namespace tractus::mesh
