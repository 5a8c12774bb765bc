#include "engine/methods/silhouettes/crown_volume.h"

#include "tests/engine/methods/silhouettes/outlines.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tractus::silhouette {
namespace {

// Returns a tree with a round crown of the given radius on the sheet, in millimetres. The sheet
// shows the tree at a tenth of its size. The trunk is vertical, and the crown's middle is twice the
// radius above the trunk's foot.
OutlinedTree round_tree(double radius = 40)
{
    std::vector<Vec2> circle;
    for (int i = 0; i <= 120; ++i) {
        double const angle = -kPi / 2 + 2 * kPi * i / 120;
        circle.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    OutlinedTree tree;
    tree.outline = stroke_of(circle);
    tree.trunk = stroke_of({ { 0, -2 * radius }, { 0, -radius }, { 0, 0 }, { 0, radius / 2 } });
    return tree;
}

TEST(CrownVolume, IsTheSolidOfRevolutionOfARoundCrown)
{
    auto const volume = crown_volume(round_tree()).value();
    // In the plant's frame, the crown is a ball with a radius of 400 mm, whose middle is at a
    // height of 800 mm.
    Vec3 const middle(0, 0, 800);
    for (int i = 0; i < 400; ++i) {
        Random random({ .seed = 5, .stream = 0, .substream = static_cast<std::uint32_t>(i) });
        Vec3 const way = Vec3(random.normal(), random.normal(), random.normal()).normalized();
        EXPECT_TRUE(volume.holds(middle + 380 * way)) << way.transpose();
        EXPECT_FALSE(volume.holds(middle + 420 * way)) << way.transpose();
    }
    EXPECT_LT((volume.box_mm().min_mm - Vec3(-400, -400, 400)).norm(), 20);
    EXPECT_LT((volume.box_mm().max_mm - Vec3(400, 400, 1200)).norm(), 20);
}

TEST(CrownVolume, IsFilledWithBallsThatStayInside)
{
    auto const volume = crown_volume(round_tree()).value();
    auto const balls = fill_with_balls(volume);
    ASSERT_GT(balls.size(), 10U);
    EXPECT_LT(balls.size(), 4000U);
    Vec3 const middle(0, 0, 800);
    double const allowed = 0.02 * 800;
    for (auto const& ball : balls)
        EXPECT_LT((ball.centre_mm - middle).norm() + ball.radius_mm, 400 + allowed);
    EXPECT_TRUE(std::is_sorted(balls.begin(), balls.end(), [](auto const& a, auto const& b) {
        return a.radius_mm > b.radius_mm;
    }));
    for (int i = 0; i < 1000; ++i) {
        Random random({ .seed = 6, .stream = 0, .substream = static_cast<std::uint32_t>(i) });
        Vec3 const way = Vec3(random.normal(), random.normal(), random.normal()).normalized();
        Vec3 const place = middle + (400 - 2 * allowed) * std::cbrt(random.uniform()) * way;
        bool const is_filled = std::any_of(balls.begin(), balls.end(), [&](auto const& ball) {
            return (ball.centre_mm - place).norm() <= ball.radius_mm;
        });
        EXPECT_TRUE(is_filled) << place.transpose();
    }
}

TEST(CrownVolume, NeedsACrown)
{
    OutlinedTree bare;
    bare.trunk = stroke_of({ { 0, 0 }, { 0, 30 }, { 0, 60 } });
    auto const none = crown_volume(bare);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("draw its outline"), std::string::npos);
    auto leaf = round_tree();
    leaf.is_leaf = true;
    EXPECT_FALSE(crown_volume(leaf));
}

TEST(CrownVolume, KnowsTheDrawnBranches)
{
    auto tree = round_tree();
    EXPECT_EQ(drawn_axes(tree).value(), std::vector { axis_key("trunk") });
    tree.branches.push_back(
        { .id = 1, .stroke = stroke_of({ { 0, -20 }, { 10, -10 }, { 20, 0 }, { 30, 5 } }) });
    auto const keys = drawn_axes(tree).value();
    ASSERT_EQ(keys.size(), 2U);
    auto const built = build_tree(tree).value();
    EXPECT_EQ(std::count(built.axis_keys.begin(), built.axis_keys.end(), keys[1]), 1);
}

} // namespace
} // namespace tractus::silhouette
