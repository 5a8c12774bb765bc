#pragma once

#include "engine/base/result.h"
#include "engine/mesh/mesh.h"

#include <string_view>

namespace tractus::exports {

// Reads the triangles of a binary glTF 2.0 file: of its default scene, with all node transforms,
// taken to our frame (millimetres, +z up). A mesh that stands in several places, by nodes or by
// EXT_mesh_gpu_instancing, becomes instances; one that stands once becomes part of the surfaces.
//
// Materials keep what read_materials.h says. Skins, animations, points and lines are not read.
//
// Fails, as the user's fault, on what is no such file, is truncated or contradicts itself, needs an
// extension that changes geometry in a way not known here, or expands to more than 67 million
// vertices. Any bytes are safe to give.
Result<mesh::Mesh> read_glb(std::string_view bytes);

} // namespace tractus::exports
