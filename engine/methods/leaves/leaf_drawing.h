#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace tractus::leaf {

// A leaf as drawn: strokes in millimetres in order of drawing, with z up or towards the viewer.
// Their roles are found by recognise_leaf().
struct LeafDrawing {
    std::vector<std::vector<Vec3>> strokes {};
    // True if several closed strokes beside a line are the leaflets of a compound leaf. False: they
    // are an error, as in older drawings.
    bool may_be_compound = true;
};

enum class StrokeRole {
    Outline,   // Outline of the leaf, or one of its halves.
    Midrib,    // Midrib, together with the petiole if it begins outside the outline.
    MainVein,  // A main vein, which begins at the beginning of the midrib.
    SideVein,  // A side vein, which begins on the midrib or another main vein.
    Stalk,     // A petiole drawn as a separate stroke.
    FinerVein, // A vein that begins on a side vein; ignored.
    Rachis,    // The line of a compound leaf on which its leaflets stand.
};
std::string_view name_of(StrokeRole role);

// A drawing in which each stroke has a role. All lines are resampled at even spacing.
struct RecognisedLeaf {
    enum class Edge { Whole, Halves, OneHalf };

    std::vector<StrokeRole> roles {}; // Role of each stroke.
    Edge edge = Edge::Whole;
    // Outline of the leaf: closed, with an arbitrary first point. If only one half was drawn, an
    // open line from base to tip.
    std::vector<Vec3> outline {};
    Vec3 normal = Vec3::UnitZ(); // Normal of the leaf's upper side.

    struct Vein {
        std::size_t stroke = 0;
        // Index of the main vein on which the vein begins; for a main vein its own index.
        std::size_t parent = 0;
        std::vector<Vec3> line; // Points of the vein, from its beginning on.
    };
    // Main veins, the midrib first. The midrib begins at the petiole's end outside the blade.
    std::vector<Vein> mains {};
    std::vector<Vein> sides {};
    std::vector<Vec3> stalk {}; // Petiole; empty unless it was drawn as a separate stroke.

    // The leaflets of a compound leaf, each as a simple leaf, in order of drawing; empty for a
    // simple leaf. A compound leaf has no outline and no veins of its own.
    std::vector<RecognisedLeaf> leaflets {};
    std::vector<Vec3> rachis {}; // The compound leaf's rachis, from the petiole's beginning.
};

// Recognises the strokes of a leaf, drawn in any order and direction: an outline (closed to within
// a few millimetres, as two halves, or as one half), a midrib, and veins that begin on the midrib
// or at its beginning. A compound leaf is recognised by at least two closed outlines beside each
// other: a line along them is the rachis, and lines inside an outline are the leaflet's veins.
// Fails with a user error that says what to draw or which stroke cannot be used; the message counts
// strokes from 1 and gives positions in millimetres.
Result<RecognisedLeaf> recognise_leaf(LeafDrawing const& drawing);

} // namespace tractus::leaf
