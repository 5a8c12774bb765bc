#pragma once

#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

namespace tractus::mesh {

float triangle_area(Vec3f const& a, Vec3f const& b, Vec3f const& c);

// Total area of the triangles, in the square of the mesh's unit.
float surface_area(TriangleMesh const& mesh);

// True if the surface has no boundary edge. Determined from the area vectors, whose sum is then
// zero even if vertices are duplicated for normals or texture seams.
bool is_closed(TriangleMesh const& mesh);

// Transforms a point of a prototype into the plant's frame.
Vec3f placed(InstanceTransform const& instance, Vec3f const& point);

// Bounding box of all vertices; empty if there are none.
Bounds bounds(TriangleMesh const& mesh);

// Bounding box of all surfaces and instances. Of an instance, the corners of its prototype's box
// are included.
Bounds bounds(Mesh const& mesh);

// The greatest dot product of `direction` with any vertex of a surface, or any corner of the box of
// an instance's prototype. Minus infinity for an empty mesh.
double reach(Mesh const& mesh, Vec3 const& direction);

} // namespace tractus::mesh
