#pragma once

#include "engine/base/random.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "tests/engine/methods/leaves/botanical_leaf.h"

#include <cstddef>
#include <vector>

namespace tractus::leaf {

// The manner in which a hand draws a leaf.
struct Manner {
    enum class Outline { Closed, Halves, OneHalf };

    double size_mm = 100; // Length of the blade.
    // Standard deviation of the tremor along x and y, at 4 to 12 Hz. The tremor in height is a
    // third of it.
    double tremor_mm = 0.3;
    double bend_deg = 0;   // Angle by which the blade bends downwards, from its base to its tip.
    double turned_deg = 0; // Rotation of the leaf about the vertical axis.
    Vec3 place_mm = Vec3::Zero();
    Outline outline = Outline::Closed;
    bool has_stalk = true;
};

// A drawing by a simulated hand, with the intended meaning of its strokes.
struct HandDrawing {
    LeafDrawing drawing;
    struct Meant {
        StrokeRole role {};
        BotanicalLeaf::Vein const* vein = nullptr; // Null unless the stroke is a main or side vein.
    };
    std::vector<Meant> meant {}; // Intended meaning of each stroke.
};

// Draws a leaf, which must outlive the result. The strokes are in any order and direction, at
// varying speed, with 100 to 500 samples a second. Their ends may be up to two millimetres wrong.
HandDrawing draw_by_hand(BotanicalLeaf const& leaf, Manner const& manner, Random& random);

} // namespace tractus::leaf
