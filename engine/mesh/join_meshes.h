#pragma once

#include "engine/mesh/mesh.h"

namespace tractus::mesh {

// Adds the triangles, instances and materials of another mesh to a mesh, moved. Both keep their
// order: the same two give the same bytes.
void append_mesh(Mesh& mesh, Mesh const& other, Vec3f const& moved_mm);

} // namespace tractus::mesh
