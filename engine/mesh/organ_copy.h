#pragma once

#include "engine/mesh/triangle_place.h"

namespace tractus::mesh {

// Writes one copy of an organ, in the plant's frame. The triangles of a mirrored copy (an odd
// number of negative scales) are reversed, so that they are counter-clockwise as seen from outside.
// `to` must have room for the vertices and indices of `prototype`.
void append_copy(TriangleMesh const& prototype, InstanceTransform const& instance,
                 TrianglePlace& to);

// Returns all copies of an organ as one mesh, in the plant's frame and in the order of the
// instances.
TriangleMesh merged_copies(InstancedMesh const& organ);

} // namespace tractus::mesh
