#pragma once

#include "app/methods/leaves/leaf_library.h"
#include "engine/mesh/mesh.h"
#include "engine/methods/leaves/leaf_paint.h"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace tractus::leaf {

// Weight of a leaf's geometry in an atlas.
enum class AtlasGeometry : std::uint8_t {
    Card,    // A rectangle.
    Cut,     // A flat shape that follows the edge; what little else it holds is transparent.
    Modelled // Bent, folded along midribs and with its edge in geometry; needs no alpha.
};

// The mesh of a leaf in its cell.
struct AtlasShape {
    std::vector<Vec2> corners {}; // Places in the cell, in pixels from its upper left corner.
    // Places from the petiole's end in millimetres: x to the right, y towards the tip, z out of the
    // upper side. The normals of flat shapes point along z.
    std::vector<Vec3> positions_mm {};
    std::vector<Vec3> normals {};
    // Counter-clockwise as seen from above.
    std::vector<std::array<std::uint32_t, 3>> triangles {};
};

// Scale of a leaf in its cell.
struct AtlasScale {
    double pixel_mm = 1;      // Side of a pixel in millimetres of the leaf.
    Vec2 stem = Vec2::Zero(); // Place of the petiole's end in the cell, in pixels.
};

// Makes the mesh of a painted leaf. `frame` must be the one that the picture was painted in. Empty
// if the picture shows nothing.
AtlasShape atlas_shape(AtlasGeometry geometry, GrownLeaf const& grown,
                       leaf::LeafPicture const& picture, leaf::PictureFrame const& frame,
                       AtlasScale const& scale);

// The mesh as exporters take it: upright, its upper side towards -y. `texture_at` maps places in
// the cell to texture coordinates of the page.
mesh::TriangleMesh upright_mesh(AtlasShape const& shape, Vec2 const& cell_corner, double page);

// The mesh as JSON: positions in metres, with z and normals if it is not flat, and texture
// coordinates as those of glTF, from the page's upper left corner.
nlohmann::ordered_json shape_json(AtlasShape const& shape, Vec2 const& cell_corner, double page);

} // namespace tractus::leaf
