#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

namespace tractus::mesh {

float triangle_area(Vec3f const& a, Vec3f const& b, Vec3f const& c);

// Sum over all triangles, in the square of the mesh's unit.
float surface_area(TriangleMesh const& mesh);

// Whether the surface has no rim: then its area vectors sum to nothing, even where vertices are
// doubled for their normals or textures.
bool is_closed(TriangleMesh const& mesh);

// Where a point of a prototype lies in the plant.
Vec3f placed(InstanceTransform const& instance, Vec3f const& point);

// The box around all vertices. Empty where there are none.
Bounds bounds(TriangleMesh const& mesh);

// The box around everything that the mesh draws, instances counted by their prototypes' corners.
Bounds bounds(Mesh const& mesh);

// How far what the mesh draws goes along `direction`, instances by their prototypes' corners: the
// greatest product of a point with it. Minus infinity where nothing is drawn.
double reach(Mesh const& mesh, Vec3 const& direction);

} // namespace tractus::mesh
