#pragma once

#include "engine/base/result.h"
#include "engine/mesh/mesh.h"

#include <string_view>

namespace tractus::exports {

// Reads the triangles of the default scene of a binary glTF 2.0 file. All node transforms are
// applied, and the triangles are converted to our frame (millimetres, +z up). A mesh that is used
// several times, by nodes or by EXT_mesh_gpu_instancing, becomes instances; a mesh that is used
// once becomes part of the surfaces.
//
// Materials are read as described in read_materials.h. Skins, animations, points and lines are
// ignored.
//
// Fails with a user error if the file is not a .glb, is truncated or inconsistent, requires an
// unsupported extension that changes geometry, or expands to more than 67 million vertices. Safe
// for arbitrary bytes.
Result<mesh::Mesh> read_glb(std::string_view bytes);

} // namespace tractus::exports
