#pragma once

#include "engine/base/bulk_vector.h"
#include "engine/export/mesh_pieces.h"

namespace tractus::exports {

// Computes the tangents that a normal map needs (glTF 2.0 section 3.7.2.1), one for each vertex. x,
// y and z are the unit vector along which u increases, orthogonal to the normal, in the frame of
// the positions. w is 1 or -1, such that w (normal x tangent) is the direction in which v decreases
// (upwards in a picture). All triangles of a vertex must be in `triangles`. If u does not vary on
// them, the tangent is an arbitrary vector orthogonal to the normal.
void find_tangents(TriangleView const& triangles, BulkVector<Eigen::Vector4f>& tangents);

} // namespace tractus::exports
