#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/leaves/leaf_cutout.h"
#include "engine/methods/leaves/leaf_paint.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// Returns the smallest rectangle that contains all visible pixels of a square picture; `alpha` is
// from 0 to 1, rows from the top. Empty if no pixel is visible.
Cutout card_around(std::span<float const> alpha, int side);

// Returns a polygon, or several with holes, that follows the edge of a leaf: it contains the pixels
// whose alpha is at least one half, and as few others as a share of `empty` of its area allows.
// Empty if there is no such pixel.
Cutout cut_along_edge(std::span<float const> alpha, int side, double empty = 0.035);

// A leaf whose edge, bend and fold are in its geometry, so that it needs no alpha.
struct ModelledLeaf {
    std::vector<Vec2> corners {};   // Places in the picture, in pixels from its upper left corner.
    std::vector<Vec3> positions {}; // In the grammar's unit, in the frame of LeafTriangles.
    std::vector<Vec3> normals {};   // Out of the upper side, of unit length.
    std::vector<std::array<std::uint32_t, 3>> triangles {}; // Counter-clockwise as seen from above.
};

struct ModelOptions {
    double fold_deg = 18;   // Angle by which each half of a blade rises from the midrib.
    int min_triangles = 60; // Long edges are divided until there are so many.
    // Details of the edge are left out until there are no more than this.
    int max_triangles = 400;
};

// Models a leaf from its picture's alpha, its triangles, which say how it bends and twists in
// space, and the midribs of its blades. `frame` must be the one that the picture was painted in.
// Empty if the picture shows nothing.
ModelledLeaf model_leaf(std::span<float const> alpha, int side, LeafTriangles const& leaf,
                        std::span<Leaf::Midrib const> midribs, PictureFrame const& frame,
                        ModelOptions const& options = {});

} // namespace tractus::leaf
