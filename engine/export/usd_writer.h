#pragma once

#include "engine/base/result.h"
#include "engine/export/picture_file.h"
#include "engine/export/placed_mesh.h"

#include <ostream>
#include <span>
#include <string_view>
#include <vector>

namespace tractus::exports {

struct UsdOptions {
    // How the copies of an organ, such as leaves, are written.
    enum class Organs {
        // As one PointInstancer per plant: small. Rotations are written twice, since readers before
        // OpenUSD 24 know only those in half precision (`orientations`, to about 0.03 degrees) and
        // later ones prefer those in single precision (`orientationsf`). The prototype of mirrored
        // copies is mirrored itself, as not every renderer turns their triangles round.
        Instanced,
        Merged, // As one mesh for each organ shape: for readers that know no PointInstancer.
    };
    Organs organs = Organs::Instanced;
};

// Writes plants as USD text (.usda, OpenUSD's UsdGeom and UsdShade schemas), in metres and +y up,
// as in our glTF files. All plants are in one Xform, "plants", with their materials; each plant is
// an Xform with a mesh for each of its surfaces, with normals and texture coordinates ("st"), and
// with its organs. Materials are UsdPreviewSurface; leaves and petals are double-sided.
//
// Returns the pictures to which the materials refer, whose names begin with `stem`; if `stem` is
// empty there are none. Plants given as functions are made one after another. The same plants
// always give the same bytes. Fails if the stream fails.
Result<std::vector<PictureFile>> write_usda(std::ostream& out, std::span<PlacedMesh const> plants,
                                            std::string_view stem = {},
                                            UsdOptions const& options = {});

} // namespace tractus::exports
