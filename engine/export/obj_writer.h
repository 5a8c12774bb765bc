#pragma once

#include "engine/base/result.h"
#include "engine/export/placed_mesh.h"

#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Writes plants as Wavefront OBJ text, in metres and +y up, as in our glTF files: an object per
// plant, a change of material per surface, and every organ written out in place. `library` is the
// name of the .mtl file from write_mtl(); if it is empty, materials are named but not defined.
// Different materials of the same name get a number appended. Fails if the stream fails.
Result<void> write_obj(std::ostream& out, std::span<PlacedMesh const> plants,
                       std::string_view library = {});

// A picture that a .mtl file refers to and that must be stored beside it.
struct MtlPicture {
    std::string name;
    std::string png;
};

// Writes the materials of the same plants as a .mtl file: colours, roughness (Pr, Pm and Ns) and
// pictures. Returns the pictures, whose names begin with `stem`; if `stem` is empty there are none.
// Plants given as functions are made again.
//
// Translucency and occlusion are left out, since MTL does not support them. A colour picture is
// multiplied by the material's own colour, since not every reader does that. Fails if the stream
// fails.
Result<std::vector<MtlPicture>> write_mtl(std::ostream& out, std::span<PlacedMesh const> plants,
                                          std::string_view stem = {});

} // namespace tractus::exports
