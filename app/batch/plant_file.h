#pragma once

#include "app/render/camera.h"
#include "app/render/picture_size.h"
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
    render::PictureSize picture {}; // Size of a picture.
    // Camera of a picture; no value: fits the whole plant.
    std::optional<render::Camera> camera {};
    exports::GlbOptions glb {};
};

// Writes a plant in the format of `path`'s extension: glTF (.glb), Wavefront OBJ (.obj, together
// with a .mtl file and images whose names begin with the same stem), a multiscale tree graph (.mtg,
// with branches and organs but no triangles), or a picture (.png).
// `name` is the plant's name inside the file. Returns the number of triangles. Fails like
// write_file(), and for a picture if the system has no OpenGL.
Result<std::uint64_t> write_plant_file(Plant const& plant, std::string const& name,
                                       std::filesystem::path const& path,
                                       PlantFileOptions const& options = {});

// Writes a plant's mesh in the format of `path`'s extension: .glb, .obj or .png. Fails like
// write_plant_file().
Result<std::uint64_t> write_mesh_file(mesh::Mesh const& mesh, std::string const& name,
                                      std::filesystem::path const& path,
                                      PlantFileOptions const& options = {});

} // namespace tractus::batch
