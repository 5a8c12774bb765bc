#pragma once

#include "engine/base/result.h"
#include "engine/mesh/closed_mesh.h"

#include <ostream>

namespace tractus::exports {

// Writes closed surfaces as a binary STL file, in millimetres and +z up, as slicers of 3D printers
// expect: for each triangle its normal and corners. Fails if the stream fails, or if there are more
// triangles than the format can count (2^32).
Result<void> write_stl(std::ostream& out, mesh::ClosedMesh const& mesh);

} // namespace tractus::exports
