#pragma once

#include "engine/base/result.h"
#include "engine/export/picture_file.h"
#include "engine/export/placed_mesh.h"

#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Writes plants as Wavefront OBJ text, in metres and +y up, as in our glTF files. Each plant is an
// object. The triangles of each surface follow the name of its material, and every copy of an organ
// is written out in place. `library` is the name of the .mtl file from write_mtl(); if it is empty,
// materials are named but not defined. Different materials of the same name are told apart by a
// number after the name. Fails if the stream fails.
Result<void> write_obj(std::ostream& out, std::span<PlacedMesh const> plants,
                       std::string_view library = {});

// Writes the materials for an OBJ file of the same plants as a .mtl file: colours, roughness (Pr
// and Ns), metalness (Pm, always 0) and pictures. Returns the pictures, whose names begin with
// `stem`; if `stem` is empty there are no pictures. Plants given as functions are made again.
//
// Translucency and occlusion are left out, since MTL does not support them. Default colour pictures
// are multiplied by the material's colour beforehand, since not every reader does that. Fails if
// the stream fails.
Result<std::vector<PictureFile>> write_mtl(std::ostream& out, std::span<PlacedMesh const> plants,
                                           std::string_view stem = {});

} // namespace tractus::exports
