#pragma once

#include "engine/mesh/mesh.h"
#include "engine/mesh/surface_mesh.h"
#include "engine/plant/organ_shape.h"

namespace tractus::mesh {

// The triangles of an organ at scale 1, in the organ frame (engine/plant/organ_shape.h).
//
// Blade: two halves along the midrib, 12 to 40 triangles for an entire margin and more for lobes,
//        one layer: materials of kind Leaf and Petal are seen from both sides. Its petiole is a
//        thin three-sided tube along +y; the curl begins where the blade does.
// Needle: four-sided, widest in the middle, pointed.
// Disc: faces +y: a cone from the origin to its rim, then a shallow dome up to `length_mm`.
// Ball: an ellipsoid from the origin to `length_mm` along +y, `width_mm` across.
// Leaf: the triangles of its cut, as long as `length_mm` before they are bent; `width_mm` and
//        `petiole_mm` are not looked at. Texture coordinates are places in the picture.
//
// Surface: see surface_mesh.h, of which `lies` is; `subdivision` as in MeshOptions.
//
// Lengths below 0 count as 0; an organ without length or width has no triangles.
TriangleMesh organ_mesh(OrganShape const& shape, int subdivision = 4,
                        TextureLies lies = TextureLies::OnBox);

} // namespace tractus::mesh
