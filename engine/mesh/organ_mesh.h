#pragma once

#include "engine/mesh/mesh.h"
#include "engine/mesh/surface_mesh.h"
#include "engine/plant/organ_shape.h"

namespace tractus::mesh {

// Returns the mesh of an organ at scale 1, in the organ frame (engine/plant/organ_shape.h), by
// kind:
//
// Blade: two halves along the midrib, 12 to 40 triangles for an entire margin and more for lobes,
//        one layer (the materials Leaf and Petal are two-sided). The petiole is a thin three-sided
//        tube along +y; the curl begins at the base of the blade.
// Needle: four-sided, widest in the middle, pointed.
// Disc: faces +y: a cone from the origin to its rim, then a shallow dome up to `length_mm`.
// Ball: an ellipsoid from the origin to `length_mm` along +y, `width_mm` across.
// Leaf: the triangles of its cut-out, scaled to `length_mm` before bending; `width_mm` and
//        `petiole_mm` are ignored. Texture coordinates are positions in the picture.
// Surface: see surface_mesh.h, also for `lies`. `subdivision` as in MeshOptions.
//
// Negative lengths count as 0; an organ without length or width has no triangles.
TriangleMesh organ_mesh(OrganShape const& shape, int subdivision = 4,
                        TextureMapping lies = TextureMapping::OnBox);

} // namespace tractus::mesh
