#pragma once

#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/leaf_triangles.h"

namespace tractus::leaf {

// A leaf as exporters and pictures take it: upright, its origin on the ground, its upper side
// towards -y, veins and limb of one material each. `size_mm` is the longer side of the flat leaf,
// which fills the unit square of texture coordinates from v = 0 on, halfway between the sides.
// Normals do not break between veins and limb. Fails, as the user's fault, if the leaf has no
// extent.
Result<mesh::Mesh> leaf_mesh(leaf::LeafTriangles const& leaf, double size_mm);

// Returns that mesh with pictures on it, as one material that is cut out along the pictures' alpha.
// Fails like leaf_mesh().
Result<mesh::Mesh> painted_leaf_mesh(leaf::LeafTriangles const& leaf,
                                     leaf::LeafPicture const& picture, double size_mm);

} // namespace tractus::leaf
