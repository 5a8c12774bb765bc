#pragma once

#include "engine/mesh/mesh.h"
#include "engine/mesh/surface_mesh.h"
#include "engine/plant/organ_shape.h"

namespace tractus::mesh {

// Returns the mesh of an organ at scale 1, in the organ frame (engine/plant/organ_shape.h), by
// kind:
//
// Blade: two halves along the midrib, with 32 triangles for an entire margin and more for lobes;
//        one layer, as the materials Leaf and Petal are two-sided. A petiole is a thin three-sided
//        tube along +y; the curl begins at the base of the blade.
// Needle: four-sided, widest in the middle, with a pointed tip.
// Disc: faces +y: a cone from the origin to its rim, then a shallow dome up to `length_mm`.
// Ball: an ellipsoid from the origin to `length_mm` along +y, `width_mm` across.
// Leaf: the triangles of the leaf's cut-out, scaled to `length_mm` before bending; `width_mm` and
//        `petiole_mm` are ignored. Texture coordinates are positions in the leaf's picture.
// Surface: the mesh of surface_mesh().
//
// `subdivision` (MeshOptions) and `lies` are used only for Surface.
//
// Negative lengths count as 0; an organ without length or width has no triangles.
TriangleMesh organ_mesh(OrganShape const& shape, int subdivision = 4,
                        TextureMapping lies = TextureMapping::OnBox);

} // namespace tractus::mesh
