#pragma once

#include "engine/base/result.h"
#include "engine/export/placed_mesh.h"

#include <ostream>
#include <span>
#include <string_view>

namespace tractus {

// Writes plants as Wavefront OBJ text: metres and +y up, as in our glTF files; an object per plant,
// a material change per surface, every organ written out where it stands. `library` is the name of
// the .mtl file that write_mtl() fills; if it is empty, materials are named but not defined. Equal
// names of materials mean equal materials: those of later plants get a number where they differ.
// Fails if the stream fails.
Result<void> write_obj(std::ostream& out, std::span<PlacedMesh const> plants,
                       std::string_view library = {});

// The materials of the same plants as a .mtl file. Makes the meshes once more where they are given
// as functions.
Result<void> write_mtl(std::ostream& out, std::span<PlacedMesh const> plants);

} // namespace tractus
