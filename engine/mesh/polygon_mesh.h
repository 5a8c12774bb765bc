#pragma once

#include "engine/mesh/mesh.h"

#include <span>

namespace tractus {

// Appends a filled polygon to `mesh`: one flat normal by Newell's method, so that counter-clockwise
// is the front; triangles by ear clipping, so that it may be concave. Texture coordinates are the
// unit square around it, v from the first vertex towards the one farthest from it, as a blade's.
// A polygon without area adds nothing. At least three vertices.
void append_polygon(std::span<Vec3 const> vertices_mm, TriangleMesh& mesh);

} // namespace tractus
