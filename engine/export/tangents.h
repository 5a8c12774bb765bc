#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/export/mesh_pieces.h"

namespace tractus::exports {

// Finds the tangents that a normal map needs besides a surface's normals (glTF 2.0 section
// 3.7.2.1): per vertex, x to z are the unit vector along which u grows, across the normal, in the
// frame of the positions; w is 1 or -1, such that w (normal x tangent) points to where v falls, the
// way up in a picture. Found from the triangles of each vertex, which must all be in `triangles`;
// where they do not tell, since u does not change there, it is any vector across the normal.
void find_tangents(TriangleView const& triangles, BulkVector<Eigen::Vector4f>& tangents);

} // namespace tractus::exports
