#include "sim/path.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus::sim {
namespace {

TEST(Path, IsAFunctionOfItsArcLength)
{
    Path const path({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 0, 0 }, { 3, 4, 0 } });
    EXPECT_DOUBLE_EQ(path.length_mm(), 7);
    EXPECT_EQ(path.position_mm(1), Vec3(1, 0, 0));
    EXPECT_EQ(path.position_mm(5), Vec3(3, 2, 0));
    EXPECT_EQ(path.direction(5), Vec3(0, 1, 0));
    EXPECT_EQ(path.position_mm(-1), Vec3(0, 0, 0));
    EXPECT_EQ(path.position_mm(8), Vec3(3, 4, 0));
}

TEST(Path, HelixWindsAndRises)
{
    auto const path = make_path(HelixShape { .foot_mm = { 10, 20, 30 },
                                             .radius_mm = 50,
                                             .end_radius_mm = 50,
                                             .turns = 2,
                                             .rise_mm = 100 });
    EXPECT_NEAR(path.length_mm(), std::hypot(4 * kPi * 50, 100), 0.1);
    EXPECT_LT((path.position_mm(0) - Vec3(60, 20, 30)).norm(), 1e-9);
    EXPECT_LT((path.position_mm(path.length_mm() / 2) - Vec3(60, 20, 80)).norm(), 0.01);
    EXPECT_LT((path.position_mm(path.length_mm() / 8) - Vec3(10, 70, 42.5)).norm(), 0.01);
}

TEST(Path, SCurveSwingsToBothSides)
{
    auto const path = make_path(
        SCurveShape { .from_mm = { 0, 0, 0 }, .to_mm = { 100, 0, 100 }, .swing_mm = 10 });
    double left = 0;
    double right = 0;
    for (auto const& point : path.points_mm()) {
        left = std::max(left, point.y());
        right = std::min(right, point.y());
    }
    EXPECT_NEAR(left, 10, 0.01);
    EXPECT_NEAR(right, -10, 0.01);
    EXPECT_LT((path.points_mm().back() - Vec3(100, 0, 100)).norm(), 1e-9);
}

TEST(Path, BranchSetsOutInItsDirectionAndBends)
{
    auto const path = make_path(BranchShape {
        .length_mm = 200, .heading_rad = kPi / 2, .elevation_rad = kPi / 2, .bend_rad = -kPi / 2 });
    EXPECT_NEAR(path.length_mm(), 200, 1e-6);
    EXPECT_LT((path.direction(0) - Vec3(0, 0, 1)).norm(), 0.01);
    EXPECT_LT((path.direction(200) - Vec3(0, 1, 0)).norm(), 0.01);
    // The path is a quarter of a circle.
    EXPECT_LT((path.points_mm().back() - Vec3(0, 400 / kPi, 400 / kPi)).norm(), 0.01);
}

TEST(Path, WhatHasNoLengthCannotBeDrawn)
{
    auto const nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_drawable(LineShape {}));
    EXPECT_FALSE(is_drawable(PolylineShape {}));
    EXPECT_FALSE(is_drawable(PolylineShape { { { 1, 2, 3 } } }));
    EXPECT_FALSE(is_drawable(HelixShape { .radius_mm = nan }));
    EXPECT_FALSE(is_drawable(HelixShape { .radius_mm = 100, .turns = 1e12 }));
    EXPECT_FALSE(is_drawable(LineShape { .to_mm = { 1e300, 1e300, 0 } }));
    EXPECT_FALSE(is_drawable(BranchShape { .length_mm = 1e5 }));
    EXPECT_TRUE(is_drawable(LineShape { .to_mm = { 1, 0, 0 } }));
}

} // namespace
} // namespace tractus::sim
