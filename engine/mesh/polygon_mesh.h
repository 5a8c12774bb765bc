#pragma once

#include "engine/mesh/triangle_place.h"

#include <span>

namespace tractus::mesh {

// A filled polygon: one flat normal by Newell's method, so that counter-clockwise is the front;
// triangles by ear clipping, so that it may be concave. Texture coordinates are the unit square
// around it, v from the first vertex towards the one farthest from it, as a blade's. A polygon
// without area has no vertices. At least three vertices are given.

// Returns what write_polygon() will write.
MeshExtent polygon_extent(std::span<Vec3 const> vertices_mm);

void write_polygon(std::span<Vec3 const> vertices_mm, TrianglePlace& place);

} // namespace tractus::mesh
