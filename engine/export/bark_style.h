#pragma once

#include "engine/base/vectors.h"
#include "engine/export/tile_noise.h"
#include "engine/plant/bark.h"

namespace tractus::exports {

// The features of a bark, each absent by default. Lengths are shares of the branch's circumference,
// which is the side of the picture; colours are sRGB.
struct BarkStyle {
    // The surface between all other features.
    struct Surface {
        Vec3 color = Vec3::Constant(0.5);
        Vec3 other_color = Vec3::Constant(0.5); // Mixed into the first one in large blotches.
        double grain = 0.05;                    // Fine variation of the lightness.
        double wrinkles = 0; // Fine lines around the branch: variation of the lightness.
        double roughness = 0.85;
    };
    Surface surface {};

    // Furrows between ridges that run along the axis, part and meet again.
    struct Furrows {
        Lattice ridges { 1, 1 };
        double width = 0;    // Half the width of a furrow, in ridges; 0: there are no furrows.
        double bridges = 1;  // How far furrows across the axis are filled: 0 not at all, 1 wholly.
        double wander = 0.3; // How far furrows leave their direction, in ridges.
        Lattice cracks { 1, 1 };   // Smaller plates into which the ridges crack.
        double crack_depth = 0;    // As a share of the furrows' depth; 0: ridges are whole.
        Vec3 color = Vec3::Zero(); // At the bottom.
    };
    Furrows furrows {};

    // Thin flakes whose edges come off.
    struct Flakes {
        Lattice cells { 1, 1 };
        double height = 0; // 0 to 1; 0: there are no flakes.
        double change = 0; // Variation of the lightness from flake to flake.
        Vec3 edge = Vec3::Constant(0.5);
    };
    Flakes flakes {};

    // Corky pores in lines around the branch.
    struct Lenticels {
        Lattice cells { 1, 1 };
        double share = 0;        // Share of the cells that have one; 0: there are none.
        double length = 0.5;     // Mean length, in cells; single ones are up to twice as long.
        double thickness = 0.15; // Half of it, in cells.
        double height = 0.3;     // Above the surface; negative: sunk into it.
        Vec3 color = Vec3::Zero();
    };
    Lenticels lenticels {};

    // Rough clefts with the shape of a rhombus, as at the foot of old birches.
    struct Clefts {
        Lattice cells { 1, 1 };
        double share = 0;  // Share of the cells that have one; 0: there are none.
        double size = 0.4; // Half of the width, in cells.
        Vec3 color = Vec3::Zero();
    };
    Clefts clefts {};

    // Pieces of several ages, where the outer bark has come off in plates.
    struct Patches {
        Lattice cells { 1, 1 };
        double share = 0;          // Share of the surface that has lost its plates; 0: none.
        Vec3 fresh = Vec3::Zero(); // Newest surface; older pieces have a colour between both.
    };
    Patches patches {};

    double depth = 0.004; // From the lowest to the highest point.
};

// The style of a kind of tree. `age` is Young or Old.
BarkStyle bark_style(BarkKind kind, BarkAge age);

// One point of a bark.
struct BarkPoint {
    double height = 0;         // 0 to 1, of the style's depth.
    Vec3 color = Vec3::Zero(); // sRGB, 0 to 1.
    double roughness = 1;      // As in Material.
};

// Computes the bark at a point of the tile: u around the branch, v along its axis, 0 to 1.
BarkPoint bark_point(BarkStyle const& style, double u, double v);

} // namespace tractus::exports
