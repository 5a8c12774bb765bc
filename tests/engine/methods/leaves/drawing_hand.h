#pragma once

#include "engine/base/random.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "tests/engine/methods/leaves/botanical_leaf.h"

#include <cstddef>
#include <vector>

namespace tractus::leaf {

// A manner of drawing a leaf.
struct Manner {
    enum class Outline { Closed, Halves, OneHalf };

    double size_mm = 100; // Length of the blade.
    // Standard deviation of the tremor along x and y, at 4 to 12 Hz; a third of it in height.
    double tremor_mm = 0.3;
    double bend_deg = 0;   // Downward bend of the blade.
    double turned_deg = 0; // Rotation about the vertical axis.
    Vec3 place_mm = Vec3::Zero();
    Outline outline = Outline::Closed;
    bool has_stalk = true;
};

// A drawing made by a simulated hand.
struct HandDrawing {
    LeafDrawing drawing;
    struct Meant {
        StrokeRole role {};
        BotanicalLeaf::Vein const* vein = nullptr; // Set for main and side veins.
    };
    std::vector<Meant> meant {}; // Intended meaning of each stroke.
};

// Draws a leaf, which must outlive the result: strokes in any order and direction, at varying
// speed, with 100 to 500 samples a second; lines begin and end up to one or two millimetres off.
HandDrawing draw_by_hand(BotanicalLeaf const& leaf, Manner const& manner, Random& random);

} // namespace tractus::leaf
