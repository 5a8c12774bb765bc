#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace tractus::leaf {

// A leaf as a pen drew it: strokes in millimetres, in the order drawn, z up or towards the viewer.
// What each stroke is does not matter here: it is recognised.
struct LeafDrawing {
    std::vector<std::vector<Vec3>> strokes {};
};

enum class StrokeRole {
    Outline,   // All of the leaf's edge, or one of its halves.
    Midrib,    // With the stalk, if it begins outside of the outline.
    MainVein,  // Begins where the midrib does.
    SideVein,  // Begins on the midrib or on another main vein.
    Stalk,     // Drawn by itself.
    FinerVein, // Begins on a side vein: left out.
};
std::string_view name_of(StrokeRole role);

// A drawing in which each stroke's part in the leaf is known. Lines are at even distances.
struct RecognisedLeaf {
    enum class Edge { Whole, Halves, OneHalf };

    std::vector<StrokeRole> roles {}; // Indexed by stroke.
    Edge edge = Edge::Whole;
    // Closed, from anywhere; of one half the line alone, from base to tip.
    std::vector<Vec3> outline {};
    Vec3 normal = Vec3::UnitZ(); // Upper side of the leaf.

    struct Vein {
        std::size_t stroke = 0;
        std::size_t parent = 0; // Main vein on which it begins; a main vein's own number.
        std::vector<Vec3> line; // Away from where it begins.
    };
    // The midrib first; it begins at the stalk's end, outside the blade.
    std::vector<Vein> mains {};
    std::vector<Vein> sides {};
    std::vector<Vec3> stalk {}; // Drawn by itself; empty otherwise.
};

// Recognises strokes in any order and direction: an outline closed within a few millimetres, as two
// halves, or as one half; a midrib; and veins that begin on it, or where it begins. Fails, as the
// user's fault, with what to draw or which stroke cannot be used: strokes count from 1, places are
// in millimetres.
Result<RecognisedLeaf> recognise_leaf(LeafDrawing const& drawing);

} // namespace tractus::leaf
