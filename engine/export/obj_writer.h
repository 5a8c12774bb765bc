#pragma once

#include "engine/base/result.h"
#include "engine/export/placed_mesh.h"

#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::exports {

// Writes plants as Wavefront OBJ text: metres and +y up, as in our glTF files; an object per plant,
// a material change per surface, every organ written out where it stands. `library` is the name of
// the .mtl file that write_mtl() fills; if it is empty, materials are named but not defined. Equal
// names of materials mean equal materials: those of later plants get a number where they differ.
// Fails if the stream fails.
Result<void> write_obj(std::ostream& out, std::span<PlacedMesh const> plants,
                       std::string_view library = {});

// A picture that a .mtl file names, which belongs beside it.
struct MtlPicture {
    std::string name;
    std::string png;
};

// The materials of the same plants as a .mtl file: colours, roughness (Pr, Pm and Ns) and pictures,
// which are answered; their names begin with `stem`, and without one there are none. Makes the
// meshes once more where they are given as functions.
//
// MTL has no word for translucency, nor for what is hidden from the sky, so these are left out. A
// colour's picture holds the material's own colour, since not every reader multiplies the two.
// Fails if the stream fails.
Result<std::vector<MtlPicture>> write_mtl(std::ostream& out, std::span<PlacedMesh const> plants,
                                          std::string_view stem = {});

} // namespace tractus::exports
