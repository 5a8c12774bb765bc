#pragma once

#include "engine/base/vectors.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::leaf {

// A flat shape on which a leaf's picture is shown: it holds all that the picture has of the leaf,
// and little else, so that little is drawn that cannot be seen.
struct Cutout {
    std::vector<Vec2> corners; // Pixels from the picture's upper left; within the picture.
    // Counter-clockwise as one looks at the picture.
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct CutoutOptions {
    float least_alpha = 0; // Pixels of at most this alpha need not be held.
    int most_corners = 16; // May be passed where the leaf has no simpler shape; at least 4.
    int most_bays = 6;     // How often the shape turns inwards.
};

// Round the pixels of a square picture, rows from the top, whose alpha is 0 to 1: their convex
// hull, cut in to the leaf where that saves most, with its shortest sides left out. Empty where
// there are no such pixels.
Cutout cut_out(std::span<float const> alpha, int side, CutoutOptions const& options = {});

} // namespace tractus::leaf
