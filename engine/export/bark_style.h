#pragma once

#include "engine/base/vectors.h"
#include "engine/export/tile_noise.h"
#include "engine/plant/bark.h"

#include <optional>

namespace tractus::exports {

// The features of a bark, each absent by default. Lengths are shares of the branch's circumference,
// which is the side of the picture; colours are sRGB.
struct BarkStyle {
    // The surface between all other features.
    struct Surface {
        Vec3f color = Vec3f::Constant(0.5F);
        Vec3f other_color = Vec3f::Constant(0.5F); // Mixed into the first one in large blotches.
        float grain = 0.05F;                       // Fine variation of the lightness.
        float wrinkles = 0; // Fine lines around the branch: variation of the lightness.
        float roughness = 0.85F;
    };
    Surface surface {};

    // Furrows between ridges that run along the axis, part and meet again.
    struct Furrows {
        Lattice ridges { 1, 1 };
        float width = 0;     // Half the width of a furrow, in ridges; 0: there are no furrows.
        float bridges = 1;   // How far furrows across the axis are filled: 0 not at all, 1 wholly.
        float wander = 0.3F; // How far furrows leave their direction, in ridges.
        Lattice cracks { 1, 1 };     // Smaller plates into which the ridges crack.
        float crack_depth = 0;       // As a share of the furrows' depth; 0: ridges are whole.
        Vec3f color = Vec3f::Zero(); // At the bottom.
    };
    Furrows furrows {};

    // Thin flakes whose edges come off.
    struct Flakes {
        Lattice cells { 1, 1 };
        float height = 0; // 0 to 1; 0: there are no flakes.
        float change = 0; // Variation of the lightness from flake to flake.
        Vec3f edge = Vec3f::Constant(0.5F);
    };
    Flakes flakes {};

    // Corky pores in lines around the branch.
    struct Lenticels {
        Lattice cells { 1, 1 };
        float share = 0;         // Share of the cells that have one; 0: there are none.
        float length = 0.5F;     // Mean length, in cells; single ones are up to twice as long.
        float thickness = 0.15F; // Half of it, in cells.
        float height = 0.3F;     // Above the surface; negative: sunk into it.
        Vec3f color = Vec3f::Zero();
    };
    Lenticels lenticels {};

    // Rough clefts with the shape of a rhombus, as at the foot of old birches.
    struct Clefts {
        Lattice cells { 1, 1 };
        float share = 0;   // Share of the cells that have one; 0: there are none.
        float size = 0.4F; // Half of the width, in cells.
        Vec3f color = Vec3f::Zero();
    };
    Clefts clefts {};

    // Pieces of several ages, where the outer bark has come off in plates.
    struct Patches {
        Lattice cells { 1, 1 };
        float share = 0;             // Share of the surface that has lost its plates; 0: none.
        Vec3f fresh = Vec3f::Zero(); // Newest surface; older pieces have a colour between both.
    };
    Patches patches {};

    float depth = 0.004F; // From the lowest to the highest point.
};

// The style of a kind of tree. `age` is Young or Old.
BarkStyle bark_style(BarkKind kind, BarkAge age);

// One point of a bark.
struct BarkPoint {
    float height = 0;            // 0 to 1, of the style's depth.
    Vec3f color = Vec3f::Zero(); // sRGB, 0 to 1.
    float roughness = 1;         // As in Material.
};

// A bark as a function of the place on it.
class BarkField {
public:
    explicit BarkField(BarkStyle const& style);

    // Computes the bark at a point of the tile: u around the branch, v along its axis, 0 to 1.
    BarkPoint at(float u, float v) const;

private:
    // The random functions of the features that the style has.
    struct SurfaceNoise {
        TileTurbulence blotches, grain, wrinkles;
    };
    struct FurrowNoise {
        TileTurbulence wander;
        TileCells ridges;
        TileNoise width;
        TileNoise shade;
        TileTurbulence crack_wander;
        TileCells cracks;
    };
    struct FlakeNoise {
        TileTurbulence bend;
        TileCells cells;
    };
    struct CleftNoise {
        TileCells cells;
        TileTurbulence edge, bottom;
    };
    struct PatchNoise {
        TileTurbulence bend_u, bend_v;
        TileCells cells;
    };

    void add_patches(BarkPoint& point, float u, float v) const;
    void add_flakes(BarkPoint& point, float u, float v) const;
    void add_furrows(BarkPoint& point, float u, float v) const;
    void add_lenticels(BarkPoint& point, float u, float v) const;
    void add_clefts(BarkPoint& point, float u, float v) const;

    BarkStyle style_;
    SurfaceNoise surface_;
    std::optional<FurrowNoise> furrows_;
    std::optional<FlakeNoise> flakes_;
    std::optional<CleftNoise> clefts_;
    std::optional<PatchNoise> patches_;
};

} // namespace tractus::exports
