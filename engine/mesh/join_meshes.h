#pragma once

#include "engine/mesh/mesh.h"

namespace tractus::mesh {

// Appends the triangles, instances and materials of `other`, translated by `moved_mm`, to `mesh`.
// The surfaces and organs of each mesh keep their order, so equal inputs give identical bytes.
void append_mesh(Mesh& mesh, Mesh const& other, Vec3f const& moved_mm);

} // namespace tractus::mesh
