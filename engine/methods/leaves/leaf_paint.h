#pragma once

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"
#include "engine/methods/leaves/paint_larvae.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace tractus::leaf {

// Placement of a leaf in its picture: it stands at the lower edge, inside an empty border.
struct PicturePlacement {
    double margin = 0.03; // Width of the empty border, as a share of the picture's side.
    enum class Middle {
        Box, // The leaf's bounding box is centred horizontally.
        Stem // The petiole's end, the middle of the first face's edge O, is centred horizontally.
    };
    Middle middle = Middle::Box;
};

struct PaintOptions {
    int side = 512; // Side of the square textures, in pixels.
    PicturePlacement stand {};
    bool has_underside = false;      // True: also paint the underside.
    double age = 0;                  // Age of the colour: 0 young, 1 old.
    Vec3 young { 0.36, 0.54, 0.22 }; // Colour of a young leaf, sRGB, 0 to 1.
    Vec3 old { 0.72, 0.50, 0.16 };
    Vec3 dead { 0.35, 0.24, 0.14 };
    // Progress from the aged colour to the dead one, 0 to 1, by the law of ageing (age_at()).
    double dead_age = 0;
    enum class First { NearVeins, BetweenVeins }; // Parts of the leaf that age first.
    First first = First::NearVeins;
    // Strength with which ageing depends on the distance from veins, by `first`.
    double near_veins = 0.8;
    double noise = 0.5; // Strength with which noise, or the distance from the tip, delays ageing.
    // Weight, 0 to 1, of the distance from the tip against noise in the delay of ageing. At 1 there
    // is no noise, and the tip ages first.
    double tip = 0;
    double spots = 0; // Share of the squares of a 16 by 16 grid that get a brown spot, 0 to 1.
    // Amount of white mildew, 0 to 1: roughly the share of the leaf that it covers.
    double mildew = 0;
    int mines = 0; // Number of leaf mines, pale tunnels of larvae under the epidermis.
    Larvae larvae {};
    bool is_skeleton = false; // True: only the veins are left.
    std::uint64_t seed = 1;
};

// Textures of a flat leaf: `side` rows from the top, each of `side` pixels. Outside the leaf (alpha
// 0) the colours of its nearest parts continue, so that mipmaps mix no other colours into it.
struct LeafPicture {
    int side = 0;
    std::vector<std::array<std::uint8_t, 4>> color;  // Colour in sRGB with straight alpha.
    std::vector<std::array<std::uint8_t, 3>> normal; // Normals as in glTF: green is up.
    // Occlusion, roughness and metalness map as in glTF: red is occlusion, green roughness, blue
    // metalness (always 0).
    std::vector<std::array<std::uint8_t, 3>> roughness;
    std::vector<std::uint8_t> translucency;
    // Textures of the underside at the same texture coordinates; empty unless requested. In
    // `under_normal` the upper side's relief is inverted and twice as deep.
    std::vector<std::array<std::uint8_t, 3>> under_color;
    std::vector<std::array<std::uint8_t, 3>> under_normal;

    // The following maps are intermediate results, one value per pixel. Away from the leaf and its
    // edge only coverage, alpha and protection have values.
    std::vector<float> coverage; // Share of the pixel covered by the leaf, before larvae.
    std::vector<float> alpha;    // Share of the pixel covered by the leaf, after larvae.
    // Distance to the nearest vein's margin, in pixels; 0 inside a vein, at most `reach`.
    std::vector<float> distance;
    std::vector<float> closeness;  // Term D of the colour law: 0 at veins, 1 half-way between them.
    std::vector<float> protection; // Protection P from larvae: 1 at a vein that they spare.
    std::vector<float> age;        // Local age m of the colour law: 0 young, 1 old.
    std::vector<float> height; // Height of the leaf's relief, in units of twice a vein's height.
    float reach = 0;
};

// Transform from the flat leaf to the picture: the longer side of the leaf's bounding box fills the
// picture inside the border.
struct PictureFrame {
    PictureFrame(LeafTriangles const& leaf, int side, PicturePlacement const& stand = {});
    Vec2 pixel(Vec2 const& flat) const
    {
        return { x0 + scale * (flat.x() - origin.x()), y0 - scale * (flat.y() - origin.y()) };
    }
    Vec2 flat(Vec2 const& pixel) const
    {
        return { origin.x() + (pixel.x() - x0) / scale, origin.y() + (y0 - pixel.y()) / scale };
    }
    // The point of the flat leaf at the horizontal middle of the picture.
    Vec2 origin = Vec2::Zero();
    double x0 = 0; // Pixel column of the point `origin`.
    double y0 = 0;
    double scale = 1; // Pixels per unit of length.
};

// Paints leaves one after another and reuses the memory. The result does not depend on the number
// of threads or on earlier leaves. Not thread-safe.
class LeafPainter {
public:
    LeafPainter();
    ~LeafPainter();
    LeafPainter(LeafPainter&&) noexcept;
    LeafPainter& operator=(LeafPainter&&) noexcept;

    // Paints a leaf. The returned picture is valid until the next call; for a leaf without extent
    // it is empty.
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

// The colour law (Peyrat et al. 2008, section 4, "two colours"): returns the local age, 0 to 1, in
// a leaf whose colour has the age `age`. `closeness` and `noise` are from 0 to 1.
double age_at(double age, double closeness, double noise, PaintOptions const& options);

} // namespace tractus::leaf
