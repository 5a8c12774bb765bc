#pragma once

#include "engine/methods/leaves/leaf.h"
#include "engine/methods/leaves/leaf_triangles.h"
#include "engine/methods/leaves/paint_larvae.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace tractus::leaf {

// How a leaf stands in its picture: on the lower edge, but for a margin.
struct PictureStand {
    double margin = 0.03; // Empty all round, as a share of the picture's side.
    enum class Middle {
        Box, // The leaf's box is in the middle,
        Stem // or the middle of the first face's edge O: the stalk's end.
    };
    Middle middle = Middle::Box;
};

struct PaintOptions {
    int side = 512; // Side of the pictures, in pixels.
    PictureStand stand {};
    bool has_underside = false;      // Whether that is painted, too.
    double age = 0;                  // 0: young, 1: old, as the colours go.
    Vec3 young { 0.36, 0.54, 0.22 }; // sRGB, 0 to 1.
    Vec3 old { 0.72, 0.50, 0.16 };
    Vec3 dead { 0.35, 0.24, 0.14 };
    double dead_age = 0; // 0 to 1: how far the old colour has become the dead one, by the same law.
    enum class First { NearVeins, BetweenVeins }; // Places that grow old first.
    First first = First::NearVeins;
    double near_veins = 0.8; // How much earlier it does.
    double noise = 0.5;      // How much later masks let places grow old.
    double tip = 0;          // 0 to 1: how much of the masks is the way from the tip, the rest
                             // patches of noise: at 1, the tip grows old first.
    double spots = 0;        // 0 to 1: how much of the leaf has brown spots.
    double mildew = 0;       // 0 to 1: how much of it is white with mildew.
    int mines = 0;           // Pale ways that larvae have eaten under its skin.
    Larvae larvae {};
    bool is_skeleton = false; // Nothing but veins is left.
    std::uint64_t seed = 1;
};

// Pictures of a flat leaf: rows from the top, `side` pixels each way. Outside of the leaf, where
// alpha is 0, the colours of what is nearest go on, so that smaller pictures mix leaves' colours
// only.
struct LeafPicture {
    int side = 0;
    std::vector<std::array<std::uint8_t, 4>> color;  // sRGB and straight alpha.
    std::vector<std::array<std::uint8_t, 3>> normal; // glTF's: green is up.
    // glTF's: red is occlusion, green roughness, blue metal, which is 0.
    std::vector<std::array<std::uint8_t, 3>> roughness;
    std::vector<std::uint8_t> translucency;
    // Pictures of the leaf seen from below, in the same places; empty unless it was asked for. Its
    // veins stand out twice as far where they are grooves above.
    std::vector<std::array<std::uint8_t, 3>> under_color;
    std::vector<std::array<std::uint8_t, 3>> under_normal;

    // Values that the pictures are made from, for each pixel. Only coverage, alpha and protection
    // have values where neither the leaf is nor its edge.
    std::vector<float> coverage;  // Share of the pixel under the leaf, before larvae.
    std::vector<float> alpha;     // Rest of it after larvae.
    std::vector<float> distance;  // To the nearest vein's side, in pixels, 0 inside; at most reach.
    std::vector<float> closeness; // D of the colour law: 0 at veins, 1 between them.
    std::vector<float> protection; // P: 1 where larvae spare a vein.
    std::vector<float> age;        // m of the colour law: 0 young, 1 old.
    std::vector<float> height; // Height of the relief, as a share of what a vein stands out twice.
    float reach = 0;
};

// Where in the picture the flat leaf lies: the longer side of its box fills it but for a margin.
struct PictureFrame {
    PictureFrame(LeafTriangles const& leaf, int side, PictureStand const& stand = {});
    Vec2 pixel(Vec2 const& flat) const
    {
        return { x0 + scale * (flat.x() - origin.x()), y0 - scale * (flat.y() - origin.y()) };
    }
    Vec2 origin = Vec2::Zero(); // Point of the flat leaf that stands on the middle,
    double x0 = 0;              // and its pixel.
    double y0 = 0;
    double scale = 1; // Pixels for a length of 1.
};

// Paints one leaf after another in the same memory. Any number of threads gives the same bytes, and
// so does a painter that has painted others before. Used by one thread at a time.
class LeafPainter {
public:
    LeafPainter();
    ~LeafPainter();
    LeafPainter(LeafPainter&&) noexcept;
    LeafPainter& operator=(LeafPainter&&) noexcept;

    // The picture stands until the next one is painted. A leaf without an extent is an empty one.
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

// The colour law (Peyrat et al. 2008, section 4, "two colours"): how old a place is, 0 to 1, of a
// leaf whose colours have that age; `closeness` and `noise` are 0 to 1.
double age_at(double age, double closeness, double noise, PaintOptions const& options);

} // namespace tractus::leaf
