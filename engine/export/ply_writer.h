#pragma once

#include "engine/base/result.h"
#include "engine/mesh/closed_mesh.h"
#include "engine/mesh/mesh.h"

#include <ostream>
#include <span>

namespace tractus::exports {

// Write triangles as a binary PLY file (little-endian), in millimetres and +z up. Vertices have
// normals and the sRGB colours of their materials; pictures are left out. Fail if the stream fails,
// or if there are 2^31 vertices or more.

// Writes a plant's mesh as it is shown, with every copy of its organs.
Result<void> write_ply(std::ostream& out, mesh::Mesh const& mesh);

// Writes closed surfaces. `materials`: those of the plant or mesh from which they were made.
Result<void> write_ply(std::ostream& out, mesh::ClosedMesh const& mesh,
                       std::span<Material const> materials);

} // namespace tractus::exports
