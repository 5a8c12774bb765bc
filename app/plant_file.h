#pragma once

#include "engine/base/result.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace tractus {

// Writes a plant as the ending of `path` says: glTF (.glb), Wavefront OBJ (.obj), or else a picture
// (.png) of all of `frame`, where that is not empty, and of the plant where it is. `name` is what
// the plant is called in the file. Answers the number of triangles. Fails like write_file(), and
// for a picture where the system has no OpenGL.
Result<std::uint64_t> write_plant_file(Plant const& plant, std::string const& name,
                                       std::filesystem::path const& path, Bounds const& frame = {});

} // namespace tractus
