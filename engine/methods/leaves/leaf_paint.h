#pragma once

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tractus::leaf {

// What larvae do to a leaf. Lengths are shares of the picture's side.
struct Larvae {
    int count = 0;
    double least_radius = 0.008; // Of a bite,
    double most_radius = 0.025;
    int least_bites = 15;
    int most_bites = 90;
    int spared_order = 2; // Veins up to this order are not eaten.
};

struct PaintOptions {
    int side = 512; // Of the pictures, in pixels; the leaf stands on the middle of the lower edge.
    double age = 0; // 0: young, 1: old, as the colours go.
    Vec3 young { 0.36, 0.54, 0.22 }; // sRGB, 0 to 1.
    Vec3 old { 0.72, 0.50, 0.16 };
    double near_veins = 0.8; // How much earlier what is near veins grows old.
    double noise = 0.5;      // How much later patches of noise do.
    double spots = 0;        // 0 to 1: how much of the leaf has brown spots.
    Larvae larvae {};
    bool is_skeleton = false; // Nothing but veins is left.
    std::uint64_t seed = 1;
};

// Pictures of a flat leaf: rows from the top, `side` pixels each way. Colours go on outside of the
// leaf, so that small pictures of it mix leaves' colours only.
struct LeafPicture {
    int side = 0;
    std::vector<std::array<std::uint8_t, 4>> color;  // sRGB and straight alpha.
    std::vector<std::array<std::uint8_t, 3>> normal; // glTF's: green is up.
    // glTF's: red is occlusion, green roughness, blue metal, which is 0.
    std::vector<std::array<std::uint8_t, 3>> roughness;
    std::vector<std::uint8_t> translucency;

    // What the pictures are made from, for each pixel.
    std::vector<float> coverage;  // Of the pixel by the leaf, before larvae: 0 to 1.
    std::vector<float> alpha;     // What is left of it.
    std::vector<float> distance;  // To the nearest vein's side, in pixels, 0 inside; at most reach.
    std::vector<float> closeness; // D of the colour law: 0 at veins, 1 between them.
    std::vector<float> protection; // P: 1 where larvae spare a vein.
    std::vector<float> age;        // m of the colour law: 0 young, 1 old.
    float reach = 0;
};

// Where in the picture the flat leaf lies: the longer side of its box fills it but for a margin.
struct PictureFrame {
    PictureFrame(LeafTriangles const& leaf, int side);
    Vec2 pixel(Vec2 const& flat) const
    {
        return { x0 + scale * (flat.x() - origin.x()), y0 - scale * (flat.y() - origin.y()) };
    }
    Vec2 origin = Vec2::Zero(); // In the flat leaf: the middle of the box's lower side,
    double x0 = 0;              // and its pixel.
    double y0 = 0;
    double scale = 1; // Pixels for a length of 1.
};

// A leaf without an extent is an empty picture. Any number of threads gives the same bytes.
LeafPicture paint_leaf(Leaf const& leaf, LeafTriangles const& triangles,
                       PaintOptions const& options);

// The colour law (Peyrat et al. 2008, section 4, "two colours"): how old a place is, 0 to 1, of a
// leaf whose colours have that age; `closeness` and `noise` are 0 to 1.
double age_at(double age, double closeness, double noise, PaintOptions const& options);

} // namespace tractus::leaf
