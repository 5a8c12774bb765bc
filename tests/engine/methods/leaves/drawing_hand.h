#pragma once

#include "engine/base/random.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "tests/engine/methods/leaves/botanical_leaf.h"

#include <cstddef>
#include <vector>

namespace tractus::leaf {

// How somebody draws a leaf.
struct Manner {
    enum class Outline { Closed, Halves, OneHalf };

    double size_mm = 100; // Length of the blade.
    double tremor_mm
        = 0.3; // Standard deviation along x and along y, at 4 to 12 Hz; a third in height.
    double bend_deg = 0;   // Bend of the blade, downwards.
    double turned_deg = 0; // About the upright.
    Vec3 place_mm = Vec3::Zero();
    Outline outline = Outline::Closed;
    bool has_stalk = true;
};

// What somebody drew.
struct HandDrawing {
    LeafDrawing drawing;
    struct Meant {
        StrokeRole role {};
        BotanicalLeaf::Vein const* vein = nullptr; // For main and side veins.
    };
    std::vector<Meant> meant {}; // By each stroke.
};

// Draws a leaf, which must outlive the result: strokes in any order and direction, at varying
// speed, places taken 100 to 500 times a second; lines begin and end up to a millimetre or two
// before or behind where they should.
HandDrawing draw_by_hand(BotanicalLeaf const& leaf, Manner const& manner, Random& random);

} // namespace tractus::leaf
