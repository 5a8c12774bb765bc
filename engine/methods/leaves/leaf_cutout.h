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
    float min_alpha = 0; // Maximum alpha of pixels that the polygon may leave out.
    // Desired maximum number of corners, at least 4. A leaf that has no simpler shape gets more.
    int most_corners = 16;
    int most_bays = 6; // Maximum number of concave corners.
};

// Computes the cutout of a square picture from its alpha (0 to 1, rows from the top). The cutout is
// the convex hull of the visible pixels, with triangles cut out where they save most area, and with
// those sides removed that cost least area. Empty if no pixel is visible.
Cutout cut_out(std::span<float const> alpha, int side, CutoutOptions const& options = {});

} // namespace tractus::leaf
