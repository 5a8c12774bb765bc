#pragma once

#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/leaf_triangles.h"

namespace tractus::leaf {

// A leaf as a mesh for exporters and renderers: upright, origin on the ground, upper side towards
// -y, with one material for veins and one for the blade. `size_mm` is the longer side of the flat
// leaf; texture coordinates fit it into the unit square, from v = 0 on and centred between the
// sides. Normals are smooth across veins and blade. Fails with a user error if the leaf has no
// extent.
Result<mesh::Mesh> leaf_mesh(leaf::LeafTriangles const& leaf, double size_mm);

// Like leaf_mesh(), with the pictures as one material, cut out by their alpha.
Result<mesh::Mesh> painted_leaf_mesh(leaf::LeafTriangles const& leaf,
                                     leaf::LeafPicture const& picture, double size_mm);

} // namespace tractus::leaf
