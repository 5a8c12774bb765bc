#pragma once

#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/leaf_triangles.h"

namespace tractus::leaf {

// A leaf as a mesh for exporters and renderers: upright, with its origin on the ground, its upper
// side towards -y, and separate materials for veins and blade. `size_mm` is the longer side of the
// flat leaf. Texture coordinates map the flat leaf into the unit square, from v = 0 on and centred
// in u. Normals are smooth across veins and blade. Fails with a user error if the leaf has no
// extent.
Result<mesh::Mesh> leaf_mesh(leaf::LeafTriangles const& leaf, double size_mm);

// Like leaf_mesh(), but with a single material that has the leaf's pictures and is cut out by their
// alpha.
Result<mesh::Mesh> painted_leaf_mesh(leaf::LeafTriangles const& leaf,
                                     leaf::LeafPicture const& picture, double size_mm);

} // namespace tractus::leaf
