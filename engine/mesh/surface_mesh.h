#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/organ_shape.h"

namespace tractus::mesh {

// The triangles of an organ of Bézier patches (OrganShape::Kind::Surface), in the organ frame.
//
// All patches are cut into the same number of strips both ways, more for a finer `subdivision`
// (MeshOptions) and for patches that bend more: 1 to 24. Patches that are named as neighbours share
// the vertices of their seam where these coincide, and its normals in any case. The texture lies
// on the surface's box: u across it, v along the organ.
TriangleMesh surface_mesh(OrganShape const& shape, int subdivision);

} // namespace tractus::mesh
