#include "engine/methods/leaves/flat_geometry.h"
#include "engine/methods/leaves/leaf_shape.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <vector>

namespace tractus::leaf {
namespace {

constexpr int kShapeSide = 256;

// Alpha of a shape whose signed distance in pixels from its edge is given, positive inside; x and y
// are those of the pixel's centre, y downwards.
std::vector<float> pictured(std::function<double(double, double)> const& inside)
{
    std::vector<float> alpha;
    for (int y = 0; y < kShapeSide; ++y)
        for (int x = 0; x < kShapeSide; ++x)
            alpha.push_back(
                static_cast<float>(std::clamp(inside(x + 0.5, y + 0.5) + 0.5, 0.0, 1.0)));
    return alpha;
}

double whole_blade(double x, double y)
{
    double const along = std::clamp((248 - y) / 240, 0.0, 1.0);
    double const half = 60 * std::sin(kPi * std::pow(along, 0.8)) + 3 * std::sin(0.5 * y);
    return y > 8 && y < 248 ? half - std::abs(x - 128) : -5;
}

double eaten_blade(double x, double y)
{
    return std::min(whole_blade(x, y), std::hypot(x - 150, y - 140) - 14);
}

double star_blade(double x, double y)
{
    double const angle = std::atan2(y - 128, x - 128);
    return 70 + 45 * std::cos(5 * angle) - std::hypot(x - 128, y - 128);
}

double thin_blade(double x, double y)
{
    return y > 8 && y < 248 ? 5 * (248 - y) / 240 + 1 - std::abs(x - 128) : -5;
}

bool shape_holds(Cutout const& shape, Vec2 const& at)
{
    return std::ranges::any_of(shape.triangles, [&](auto const& triangle) {
        Vec2 const& a = shape.corners[triangle[0]];
        Vec2 const& b = shape.corners[triangle[1]];
        Vec2 const& c = shape.corners[triangle[2]];
        return turn(a, b, at) <= 1e-9 && turn(b, c, at) <= 1e-9 && turn(c, a, at) <= 1e-9;
    });
}

struct ShapeFit {
    double held = 0;  // Share of the leaf's pixels that the shape holds.
    double empty = 0; // Share of the shape's pixels that are none of the leaf's.
};

ShapeFit shape_fit(Cutout const& shape, std::vector<float> const& alpha)
{
    double leaf = 0;
    double inside = 0;
    double both = 0;
    for (int y = 0; y < kShapeSide; ++y)
        for (int x = 0; x < kShapeSide; ++x) {
            bool const is_leaf = alpha[static_cast<std::size_t>(y * kShapeSide + x)] >= 0.5f;
            bool const is_held = shape_holds(shape, { x + 0.5, y + 0.5 });
            leaf += is_leaf;
            inside += is_held;
            both += is_leaf && is_held;
        }
    return { both / leaf, 1 - both / inside };
}

TEST(LeafShape, CutsAlongTheEdge)
{
    for (auto const& leaf : { whole_blade, eaten_blade, star_blade, thin_blade }) {
        auto const alpha = pictured(leaf);
        auto const shape = cut_along_edge(alpha, kShapeSide);
        auto const found = shape_fit(shape, alpha);
        EXPECT_GE(found.held, 0.99);
        EXPECT_LE(found.empty, 0.05);
        EXPECT_LT(shape.triangles.size(), 150u);
    }
}

TEST(LeafShape, PutsACardAroundAll)
{
    auto const card = card_around(pictured(thin_blade), kShapeSide);
    ASSERT_EQ(card.corners.size(), 4u);
    ASSERT_EQ(card.triangles.size(), 2u);
    EXPECT_EQ(card.corners[0], Vec2(122, 248));
    EXPECT_EQ(card.corners[2], Vec2(134, 8));
    EXPECT_TRUE(shape_holds(card, { 130, 30 }));
}

TEST(LeafShape, IsEmptyRoundNothing)
{
    std::vector<float> const nothing(std::size_t { kShapeSide } * kShapeSide, 0);
    EXPECT_TRUE(card_around(nothing, kShapeSide).triangles.empty());
    EXPECT_TRUE(cut_along_edge(nothing, kShapeSide).triangles.empty());
}

// A flat blade, bent down along its midrib by 60 degrees in all.
LeafTriangles arched_leaf()
{
    LeafTriangles leaf;
    constexpr int kRows = 24;
    for (int i = 0; i <= kRows; ++i)
        for (double const x : { -64.0, 0.0, 64.0 }) {
            double const y = 240.0 * i / kRows;
            double const angle = kPi / 3 * i / kRows;
            double const radius = 240 / (kPi / 3);
            leaf.flat.emplace_back(x, y);
            leaf.positions.emplace_back(x, radius * std::sin(angle),
                                        radius * (std::cos(angle) - 1));
        }
    for (std::uint32_t i = 0; i < kRows; ++i)
        for (std::uint32_t k = 0; k < 2; ++k) {
            auto const a = 3 * i + k;
            leaf.limb.push_back({ a, a + 1, a + 4 });
            leaf.limb.push_back({ a, a + 4, a + 3 });
        }
    return leaf;
}

PictureFrame frame_of_blade()
{
    PictureFrame frame(arched_leaf(), kShapeSide);
    frame.origin = { 0, 0 };
    frame.x0 = 128;
    frame.y0 = 248;
    frame.scale = 1;
    return frame;
}

TEST(LeafShape, ModelsABentAndFoldedLeafWithoutAlpha)
{
    std::vector<Leaf::Midrib> const midribs { { Vec2(0, 0), Vec2(0, 240) } };
    for (auto const& leaf : { whole_blade, eaten_blade }) {
        auto const alpha = pictured(leaf);
        auto const frame = frame_of_blade();
        auto const model = model_leaf(alpha, kShapeSide, arched_leaf(), midribs, frame);
        EXPECT_GE(model.triangles.size(), 60u);
        EXPECT_LE(model.triangles.size(), 400u);
        auto const found = shape_fit({ model.corners, model.triangles }, alpha);
        EXPECT_GE(found.held, 0.98);
        EXPECT_LE(found.empty, 0.02);
        double lowest = 1;
        double most_left = 0;
        double most_right = 0;
        for (auto const& normal : model.normals) {
            EXPECT_NEAR(normal.norm(), 1, 1e-9);
            lowest = std::min(lowest, normal.z());
            most_left = std::max(most_left, -normal.x());
            most_right = std::max(most_right, normal.x());
        }
        EXPECT_LT(lowest, std::cos(kPi / 4)); // The tip hangs.
        EXPECT_GT(most_left, 0.2);            // Each half faces the other.
        EXPECT_GT(most_right, 0.2);
    }
}

// No triangle lies on both sides of the midrib, or the blade would not fold on it.
TEST(LeafShape, FoldsOnTheMidrib)
{
    std::vector<Leaf::Midrib> const midribs { { Vec2(0, 0), Vec2(0, 240) } };
    auto const model
        = model_leaf(pictured(whole_blade), kShapeSide, arched_leaf(), midribs, frame_of_blade());
    double across = 0;
    double all = 0;
    for (auto const& triangle : model.triangles) {
        double left = 0;
        double right = 0;
        for (auto const corner : triangle) {
            left = std::max(left, 128 - model.corners[corner].x());
            right = std::max(right, model.corners[corner].x() - 128);
        }
        double const area = std::abs(turn(model.corners[triangle[0]], model.corners[triangle[1]],
                                          model.corners[triangle[2]]));
        all += area;
        across += left > 1 && right > 1 ? area : 0;
    }
    EXPECT_LT(across, 0.03 * all);
}

} // namespace
} // namespace tractus::leaf
