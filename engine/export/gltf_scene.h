#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/export/tinygltf.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Shared parts of the readers of glTF files.

// An error, as the user's fault, that begins with what all of them say.
tl::unexpected<Error> fail_reading(std::string const& reason);

// The parsed JSON part and the buffer of a binary glTF 2.0 file; pictures are not looked at. Fails
// on what is no such file, is truncated or nested too deeply, or needs an extension that changes
// geometry in a way not known here. Any bytes are safe to give.
Result<tinygltf::Model> parse_glb(std::string_view bytes);

using Affine = Eigen::Affine3d;

// Where each mesh of a file stands: transforms to the scene's frame, one for each node or instance
// (EXT_mesh_gpu_instancing) of its default scene; without scenes, of every node that is nobody's
// child, and what they bear. Fails on nodes and attributes that contradict each other.
Result<std::vector<std::vector<Affine>>> find_places(tinygltf::Model const& model);

// The number of a primitive's accessor, "POSITION" and so on; -1 without.
int accessor_of(tinygltf::Primitive const& primitive, char const* name);

} // namespace tractus::exports
