#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// A flat polygon that shows a leaf's picture. It contains all visible pixels of the leaf and little
// else, to reduce overdraw.
struct Cutout {
    // Corners in pixels from the picture's upper left corner; within the picture.
    std::vector<Vec2> corners;
    // Triangles, counter-clockwise as seen by a viewer of the picture.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct CutoutOptions {
    float min_alpha = 0; // Maximum alpha of pixels that may be outside.
    // Target number of corners, at least 4; exceeded if the leaf has no simpler shape.
    int most_corners = 16;
    int most_bays = 6; // Greatest number of concave corners.
};

// Computes the cutout of a square picture from its alpha (0 to 1, rows from the top): the convex
// hull of the visible pixels, cut inwards where that saves most area, with the shortest sides
// removed. Empty if no pixel is visible.
Cutout cut_out(std::span<float const> alpha, int side, CutoutOptions const& options = {});

} // namespace tractus::leaf
