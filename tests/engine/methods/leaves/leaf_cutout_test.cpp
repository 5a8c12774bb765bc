#include "engine/methods/leaves/leaf_cutout.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::leaf {
namespace {

constexpr int kCutSide = 128;

template<typename IsThere> std::vector<float> picture(IsThere const& is_there)
{
    std::vector<float> alpha;
    for (int y = 0; y < kCutSide; ++y)
        for (int x = 0; x < kCutSide; ++x)
            alpha.push_back(is_there(x, y) ? 1.0f : 0.0f);
    return alpha;
}

// True if a pixel is in a cross. The convex hull of a cross is much larger than the cross itself.
bool is_cross(int x, int y)
{
    bool const is_upright = x >= 56 && x < 72 && y >= 10 && y < 120;
    return is_upright || (y >= 50 && y < 66 && x >= 8 && x < 118);
}

bool is_star(int x, int y)
{
    double const angle = std::atan2(y - 64.0, x - 64.0);
    return std::hypot(x - 64.0, y - 64.0) < 34 + 24 * std::cos(5 * angle);
}

double turn_of(Vec2 const& a, Vec2 const& b, Vec2 const& c)
{
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

double area(Cutout const& shape)
{
    double sum = 0;
    for (auto const& [a, b, c] : shape.triangles)
        sum += 0.5 * std::abs(turn_of(shape.corners[a], shape.corners[b], shape.corners[c]));
    return sum;
}

// True if one of the triangles contains a point. The corners of a triangle are clockwise, with y
// downwards.
bool holds(Cutout const& shape, Vec2 const& at)
{
    for (auto const& [a, b, c] : shape.triangles) {
        auto const& p = shape.corners[a];
        auto const& q = shape.corners[b];
        auto const& r = shape.corners[c];
        if (turn_of(p, q, at) <= 1e-6 && turn_of(q, r, at) <= 1e-6 && turn_of(r, p, at) <= 1e-6)
            return true;
    }
    return false;
}

void expect_holds_all(std::vector<float> const& alpha, Cutout const& shape)
{
    for (int y = 0; y < kCutSide; ++y)
        for (int x = 0; x < kCutSide; ++x)
            if (alpha[static_cast<std::size_t>(y * kCutSide + x)] > 0) {
                ASSERT_TRUE(holds(shape, { x + 0.5, y + 0.5 })) << x << " " << y;
            }
}

TEST(LeafCutout, HoldsAllThatIsThere)
{
    for (auto const& is_there : { is_cross, is_star }) {
        auto const alpha = picture(is_there);
        for (int const corners : { 6, 8, 12, 16, 24 })
            expect_holds_all(alpha, cut_out(alpha, kCutSide, { .most_corners = corners }));
    }
}

TEST(LeafCutout, HasTwoTrianglesLessThanCorners)
{
    for (int const corners : { 8, 16 }) {
        // Bays need more corners. Eight corners are enough for the hull of a star, but not for its
        // bays.
        CutoutOptions const options { .most_corners = corners, .most_bays = corners < 16 ? 0 : 6 };
        auto const shape = cut_out(picture(is_star), kCutSide, options);
        EXPECT_LE(shape.corners.size(), static_cast<std::size_t>(corners));
        EXPECT_EQ(shape.triangles.size(), shape.corners.size() - 2);
        for (auto const& corner : shape.corners) {
            EXPECT_GE(corner.minCoeff(), 0);
            EXPECT_LE(corner.maxCoeff(), kCutSide);
        }
    }
}

TEST(LeafCutout, CutsInWhereNothingIs)
{
    auto const alpha = picture(is_cross);
    auto const hull = cut_out(alpha, kCutSide, { .most_bays = 0 });
    auto const shape = cut_out(alpha, kCutSide, { .most_bays = 4 });
    double const there = 16 * 110 + 16 * 110 - 16 * 16;
    EXPECT_GE(area(hull), there);
    EXPECT_LT(area(shape), 1.2 * there);
    EXPECT_LT(area(shape), 0.6 * area(hull));
}

TEST(LeafCutout, IsEmptyRoundNothing)
{
    auto const shape = cut_out(picture([](int, int) { return false; }), kCutSide);
    EXPECT_TRUE(shape.corners.empty());
    EXPECT_TRUE(shape.triangles.empty());
}

} // namespace
} // namespace tractus::leaf
