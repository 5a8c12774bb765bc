#pragma once

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"
#include "engine/methods/leaves/paint_larvae.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace tractus::leaf {

// Placement of a leaf in its picture: at the lower edge, inside a margin.
struct PicturePlacement {
    double margin = 0.03; // Empty border, as a share of the picture's side.
    enum class Middle {
        Box, // The leaf's bounding box is centred horizontally.
        Stem // The petiole's end, the middle of the first face's edge O, is centred horizontally.
    };
    Middle middle = Middle::Box;
};

struct PaintOptions {
    int side = 512; // Side of the square pictures, in pixels.
    PicturePlacement stand {};
    bool has_underside = false;      // True: also paint the underside.
    double age = 0;                  // Colour age, 0 young to 1 old.
    Vec3 young { 0.36, 0.54, 0.22 }; // Colour of a young leaf, sRGB, 0 to 1.
    Vec3 old { 0.72, 0.50, 0.16 };
    Vec3 dead { 0.35, 0.24, 0.14 };
    // Progress from the old to the dead colour, 0 to 1, by the same law as ageing.
    double dead_age = 0;
    enum class First { NearVeins, BetweenVeins }; // The places that age first.
    First first = First::NearVeins;
    double near_veins = 0.8; // Strength with which ageing depends on the distance from veins.
    double noise = 0.5;      // Strength with which noise (and `tip`) delays ageing.
    // Weight, 0 to 1, of the distance from the tip in the delay of ageing; the rest is noise. At 1
    // the tip ages first.
    double tip = 0;
    double spots = 0;  // Share of the leaf with brown spots, 0 to 1.
    double mildew = 0; // Share of the leaf with white mildew, 0 to 1.
    int mines = 0;     // Number of leaf mines, pale tunnels of larvae under the epidermis.
    Larvae larvae {};
    bool is_skeleton = false; // True: only the veins are left.
    std::uint64_t seed = 1;
};

// Textures of a flat leaf: `side` rows from the top of `side` pixels. Outside the leaf (alpha 0)
// the colours of the nearest parts continue, so that mipmaps only mix colours of the leaf.
struct LeafPicture {
    int side = 0;
    std::vector<std::array<std::uint8_t, 4>> color;  // Colour in sRGB with straight alpha.
    std::vector<std::array<std::uint8_t, 3>> normal; // Normals as in glTF: green is up.
    // Roughness map as in glTF: red is occlusion, green roughness, blue metalness (0).
    std::vector<std::array<std::uint8_t, 3>> roughness;
    std::vector<std::uint8_t> translucency;
    // Textures of the underside at the same texture coordinates; empty unless requested. Veins that
    // are grooves on the upper side stand out twice as far here.
    std::vector<std::array<std::uint8_t, 3>> under_color;
    std::vector<std::array<std::uint8_t, 3>> under_normal;

    // Intermediate maps, one value per pixel. Outside the leaf and its edge only coverage, alpha
    // and protection have values.
    std::vector<float> coverage; // Share of the pixel covered by the leaf, before larvae.
    std::vector<float> alpha;    // Share of the pixel covered by the leaf, after larvae.
    // Distance to the nearest vein's side, in pixels; 0 inside, at most reach.
    std::vector<float> distance;
    std::vector<float> closeness;  // Closeness D of the colour law: 0 at veins, 1 between them.
    std::vector<float> protection; // Protection P: 1 where larvae spare a vein.
    std::vector<float> age;        // Local age m of the colour law: 0 young, 1 old.
    std::vector<float> height;     // Height of the relief, in units of twice a vein's height.
    float reach = 0;
};

// Transform from the flat leaf to the picture: the longer side of its bounding box fills the
// picture inside the margin.
struct PictureFrame {
    PictureFrame(LeafTriangles const& leaf, int side, PicturePlacement const& stand = {});
    Vec2 pixel(Vec2 const& flat) const
    {
        return { x0 + scale * (flat.x() - origin.x()), y0 - scale * (flat.y() - origin.y()) };
    }
    // The point of the flat leaf at the horizontal middle of the picture.
    Vec2 origin = Vec2::Zero();
    double x0 = 0; // Pixel column of the point `origin`.
    double y0 = 0;
    double scale = 1; // Pixels per unit of length.
};

// Paints leaves one after another in the same memory. The result does not depend on the number of
// threads or on earlier leaves. Not thread-safe.
class LeafPainter {
public:
    LeafPainter();
    ~LeafPainter();
    LeafPainter(LeafPainter&&) noexcept;
    LeafPainter& operator=(LeafPainter&&) noexcept;

    // The result is valid until the next call. A leaf without extent gives an empty picture.
    LeafPicture const& paint(Leaf const& leaf, LeafTriangles const& triangles,
                             PaintOptions const& options);

private:
    friend class LeafBrush;
    struct Canvas;
    std::unique_ptr<Canvas> canvas_;
};

// Paints a single leaf.
LeafPicture paint_leaf(Leaf const& leaf, LeafTriangles const& triangles,
                       PaintOptions const& options);

// The colour law (Peyrat et al. 2008, section 4, "two colours"): local age, 0 to 1, in a leaf of
// colour age `age`; `closeness` and `noise` are 0 to 1.
double age_at(double age, double closeness, double noise, PaintOptions const& options);

} // namespace tractus::leaf
