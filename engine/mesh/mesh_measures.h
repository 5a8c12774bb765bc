#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

namespace tractus::mesh {

float triangle_area(Vec3f const& a, Vec3f const& b, Vec3f const& c);

// Total area of the triangles, in the square of the mesh's unit of length.
float surface_area(TriangleMesh const& mesh);

// True if the surface has no boundary edge. The test is that the area vectors of its triangles sum
// to about zero, which also works if vertices are duplicated for normals or texture seams.
bool is_closed(TriangleMesh const& mesh);

// Transforms a point of a prototype into the plant's frame.
Vec3f placed(InstanceTransform const& instance, Vec3f const& point);

// Bounding box of all vertices; empty if there are none.
Bounds bounds(TriangleMesh const& mesh);

// Bounding box of all surfaces and instances. An instance counts as the box of its prototype,
// transformed with it, so the result may be too large.
Bounds bounds(Mesh const& mesh);

// Returns the greatest dot product of `direction` with a vertex of a surface or with a corner of an
// instance's box (that of the prototype, transformed). Minus infinity for an empty mesh.
double reach(Mesh const& mesh, Vec3 const& direction);

} // namespace tractus::mesh
