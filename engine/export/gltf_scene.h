#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/export/tinygltf.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Functions shared by the readers of glTF files.

// Returns a user error whose message is "cannot read the glTF file: " and the reason.
tl::unexpected<Error> fail_reading(std::string const& reason);

// Parses the JSON and the buffer of a binary glTF 2.0 file; pictures are not decoded. Fails if the
// file is not a .glb, is truncated or nested too deeply, or requires an unsupported extension that
// changes geometry. Safe for arbitrary bytes.
Result<tinygltf::Model> parse_glb(std::string_view bytes);

using Affine = Eigen::Affine3d;

// Returns, for each mesh of a file, the transforms of all its uses to the scene's frame. Each node
// or instance (EXT_mesh_gpu_instancing) of the default scene that has the mesh is a use. If there
// are no scenes, all nodes count. Fails if nodes or attributes are inconsistent.
Result<std::vector<std::vector<Affine>>> find_places(tinygltf::Model const& model);

// Returns the index of a primitive's accessor for an attribute such as "POSITION"; -1 if the
// primitive lacks the attribute.
int accessor_of(tinygltf::Primitive const& primitive, char const* name);

} // namespace tractus::exports
