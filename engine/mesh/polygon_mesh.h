#pragma once

#include "engine/mesh/triangle_place.h"

#include <span>

namespace tractus::mesh {

// Meshes of filled polygons. A polygon has one normal, by Newell's method, so that its
// counter-clockwise side is the front. It is triangulated by ear clipping, so it may be concave.
// Texture coordinates fill the unit square, with v from the first vertex towards the one farthest
// from it, as for a blade. The mesh of a polygon without area has no vertices. `vertices_mm`: at
// least three vertices.

// Returns the numbers of vertices and indices that write_polygon() writes.
MeshExtent polygon_extent(std::span<Vec3 const> vertices_mm);

void write_polygon(std::span<Vec3 const> vertices_mm, TrianglePlace& place);

} // namespace tractus::mesh
