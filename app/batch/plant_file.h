#pragma once

#include "app/batch/plant_format.h"

namespace tractus::batch {

// Writes a plant in the format of `path`'s extension, one of plant_endings(): glTF (.glb),
// Wavefront OBJ (.obj, together with a .mtl file and images whose names begin with the same stem),
// USD (.usda, with such images), triangles for viewing or printing (.ply, .stl), a multiscale tree
// graph (.mtg, with branches and organs but no triangles), or a picture (.png).
// `name` is the plant's name inside the file. Fails like write_file(), for a picture if the system
// has no OpenGL, and for a watertight file if the plant is too large for its thickness.
Result<WrittenFile> write_plant_file(Plant const& plant, std::string const& name,
                                     std::filesystem::path const& path,
                                     PlantFileOptions const& options = {});

// Writes a plant's mesh in the format of `path`'s extension, one of mesh_endings(). Fails like
// write_plant_file().
Result<WrittenFile> write_mesh_file(mesh::Mesh const& mesh, std::string const& name,
                                    std::filesystem::path const& path,
                                    PlantFileOptions const& options = {});

} // namespace tractus::batch
