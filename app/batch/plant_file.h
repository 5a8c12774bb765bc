#pragma once

#include "app/render/camera.h"
#include "engine/base/result.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tractus::batch {

struct PlantFileOptions {
    // Camera of a picture; without it, all of the plant is seen.
    std::optional<render::Camera> camera {};
    exports::GlbOptions glb {};
};

// Writes a plant as the ending of `path` says: glTF (.glb), Wavefront OBJ (.obj, with a .mtl and
// pictures beside it whose names begin alike), a multiscale tree graph (.mtg, which has branches
// and organs and no triangles), or else a picture (.png), of PictureSize's size. `name` is what the
// plant is called in the file. Returns the number of triangles. Fails like write_file(), and for a
// picture where the system has no OpenGL.
Result<std::uint64_t> write_plant_file(Plant const& plant, std::string const& name,
                                       std::filesystem::path const& path,
                                       PlantFileOptions const& options = {});

// Writes a plant that is meshed already, in any of these but as a graph. Fails like
// write_plant_file().
Result<std::uint64_t> write_mesh_file(mesh::Mesh const& mesh, std::string const& name,
                                      std::filesystem::path const& path,
                                      PlantFileOptions const& options = {});

} // namespace tractus::batch
