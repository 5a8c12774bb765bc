#include "engine/variation/selection.h"

#include "tests/engine/variation/plants.h"

#include "engine/base/random.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace tractus::variation {
namespace {

using Path = std::vector<SegmentId>;
using Paths = std::vector<Path>;
using enum SegmentState;

// Returns the tree of figure 5. Axis A (0) has the branches B (1) to the left and C (2) upwards. D
// (3) is on C, E (4) on B, and F (5) on D.
Plant figure_5()
{
    Plant plant;
    auto const a = add_axis(plant, { { 0, 0, 0 }, { 0, 0, 100 } });
    auto const b = add_axis(plant, { { 0, 0, 100 }, { -60, 0, 160 } }, a, 0);
    auto const c = add_axis(plant, { { 0, 0, 100 }, { 20, 0, 200 } }, a, 0);
    auto const d = add_axis(plant, { { 20, 0, 200 }, { 60, 0, 300 } }, c, 2);
    add_axis(plant, { { -60, 0, 160 }, { -90, 0, 240 } }, b, 1);
    add_axis(plant, { { 60, 0, 300 }, { 60, 0, 400 } }, d, 3);
    return plant;
}

class Figure5 : public testing::Test {
protected:
    BranchTree tree = build_branch_tree(figure_5());
    PathSelection selection { tree };

    void touch(Path const& segments)
    {
        for (auto const segment : segments)
            selection.touch(segment);
    }
};

TEST_F(Figure5, TheFirstBranchIsSelectedAtOnce)
{
    EXPECT_TRUE(selection.touch(0));
    EXPECT_EQ(selection.state(0), Selected);
}

TEST_F(Figure5, ChildrenStayUndetermined)
{
    touch({ 0, 1, 2 });
    EXPECT_EQ(selection.state(1), Undetermined);
    EXPECT_EQ(selection.state(2), Undetermined);
    EXPECT_EQ(selection.selected(), (Path { 0 }));
    EXPECT_EQ(selection.undetermined(), (Path { 1, 2 }));
}

TEST_F(Figure5, AGrandchildShowsWhichChildWasMeant)
{
    touch({ 0, 1, 2, 3 });
    EXPECT_EQ(selection.state(0), Selected);
    EXPECT_EQ(selection.state(1), Unselected);
    EXPECT_EQ(selection.state(2), Selected);
    EXPECT_EQ(selection.state(3), Undetermined);
    EXPECT_EQ(selection.finish(), (Paths { { 0, 2, 3 } }));
    EXPECT_EQ(selection.state(3), Selected);
}

TEST_F(Figure5, TheOtherGrandchildShowsTheOtherChild)
{
    touch({ 0, 1, 2, 4 });
    EXPECT_EQ(selection.state(1), Selected);
    EXPECT_EQ(selection.state(2), Unselected);
    EXPECT_EQ(selection.state(4), Undetermined);
    EXPECT_EQ(selection.finish(), (Paths { { 0, 1, 4 } }));
}

TEST_F(Figure5, WhatIsUndeterminedInTheEndBecomesSelected)
{
    touch({ 0, 1, 2 });
    EXPECT_EQ(selection.finish(), (Paths { { 0, 1 }, { 0, 2 } }));
    EXPECT_EQ(selection.state(1), Selected);
    EXPECT_EQ(selection.state(2), Selected);
}

TEST_F(Figure5, SkippedBranchesAreFilledIn)
{
    touch({ 0, 5 });
    EXPECT_EQ(selection.selected(), (Path { 0, 2, 3 }));
    EXPECT_EQ(selection.finish(), (Paths { { 0, 2, 3, 5 } }));
}

TEST_F(Figure5, SkippedBranchesDecideToo)
{
    touch({ 0, 1, 3 });
    EXPECT_EQ(selection.state(1), Unselected);
    EXPECT_EQ(selection.state(2), Selected);
}

TEST_F(Figure5, ThereIsNoWayBackDown)
{
    touch({ 2, 3, 5 });
    EXPECT_FALSE(selection.touch(0));
    EXPECT_FALSE(selection.touch(2));
    EXPECT_FALSE(selection.touch(1));
    EXPECT_EQ(selection.finish(), (Paths { { 2, 3, 5 } }));
}

TEST_F(Figure5, TouchingAgainChangesNothing)
{
    touch({ 0, 1 });
    EXPECT_FALSE(selection.touch(1));
    EXPECT_FALSE(selection.touch(0));
    EXPECT_EQ(selection.finish(), (Paths { { 0, 1 } }));
}

TEST_F(Figure5, NothingTouchedSelectsNothing)
{
    EXPECT_TRUE(selection.finish().empty());
}

TEST_F(Figure5, ClearForgetsEverything)
{
    touch({ 0, 1, 2, 3 });
    selection.clear();
    for (SegmentId segment = 0; segment < 6; ++segment)
        EXPECT_EQ(selection.state(segment), Unselected);
    touch({ 4 });
    EXPECT_EQ(selection.finish(), (Paths { { 4 } }));
}

// Returns a view along +y: u is x, v is z, and the depth is y.
SkeletonProjection front_view(double half_size)
{
    SkeletonProjection view;
    view.to_plane << 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1;
    view.min = Vec2::Constant(-half_size);
    view.max = Vec2::Constant(half_size);
    return view;
}

TEST_F(Figure5, APenDrawnOverTheSkeletonSelects)
{
    ProjectedSkeleton const skeleton(figure_5(), front_view(500));
    SelectionPen pen(skeleton, tree, selection);
    // The pen follows A, touches B slightly by mistake, and then follows C, D and F.
    for (auto const& point :
         { Vec2(2, 20), Vec2(1, 90), Vec2(-20, 120), Vec2(12, 150), Vec2(40, 250), Vec2(60, 380) })
        pen.move_to(point);
    EXPECT_EQ(selection.finish(), (Paths { { 0, 2, 3, 5 } }));
}

TEST(SelectionPen, MissesNoThinBranchAtSpeed)
{
    // The twigs are like the teeth of a comb. The pen moves across all of them once.
    auto plant = pole(50, 500);
    for (SegmentId segment = 0; segment < 49; ++segment)
        add_axis(plant, { { 0, 0, 10.0 * segment + 10 }, { 100, 0, 10.0 * segment + 10 } }, 0,
                 segment);
    auto const tree = build_branch_tree(plant);
    ProjectedSkeleton const skeleton(plant, front_view(600));
    PathSelection selection(tree);
    SelectionPen pen(skeleton, tree, selection, { .line_half_width = 0.5, .finger = 0.5 });
    pen.move_to({ 0, 1 });
    pen.move_to({ 0, 499 });
    EXPECT_EQ(selection.selected().size(), 49u);
    auto const paths = selection.finish();
    EXPECT_EQ(paths.back().back(), 49u);
    EXPECT_EQ(paths.back().size(), 50u);
}

TEST(SelectionPen, FollowsTheTrunkBehindBranchesThatGrowTowardsTheEye)
{
    // Each branch leaves the trunk towards the eye (-y), and then rises. It hides the next 25 mm of
    // the trunk.
    auto plant = pole(10, 100);
    for (SegmentId segment = 1; segment < 6; segment += 2) {
        double const z = 10.0 * segment + 10;
        add_axis(plant, { { 0, 0, z }, { 0, -20, z + 12 }, { 0, -40, z + 25 } }, 0, segment);
    }
    auto const tree = build_branch_tree(plant);
    ProjectedSkeleton const skeleton(plant, front_view(200));
    PathSelection selection(tree);
    SelectionPen pen(skeleton, tree, selection);
    for (double z = 2; z <= 98; z += 3)
        pen.move_to({ 0, z });
    EXPECT_EQ(pen.lift(), (Paths { { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } }));
}

TEST(SelectionPen, FollowsOneOfTwoStemsThatLeaveTheGroundAtOnePlace)
{
    Plant plant;
    add_axis(plant, { { 0, -5, 0 }, { 1, -5, 30 }, { 30, -5, 60 }, { 60, -5, 90 } });
    add_axis(plant, { { 0, 5, 0 }, { -1, 5, 30 }, { -30, 5, 60 }, { -60, 5, 90 } });
    auto const tree = build_branch_tree(plant);
    ProjectedSkeleton const skeleton(plant, front_view(200));
    PathSelection selection(tree);
    SelectionPen pen(skeleton, tree, selection);
    for (auto const& point : { Vec2(0, 10), Vec2(-1, 30), Vec2(-30, 60), Vec2(-50, 80) })
        // The pen follows the rear stem from the place where the front stem hides it.
        pen.move_to(point);
    EXPECT_EQ(pen.lift(), (Paths { { 3, 4, 5 } }));
}

TEST(SelectionPen, TakesTheNearestWhereItIsLiftedOverSeveral)
{
    auto plant = pole(4, 40);
    add_axis(plant, { { 0, 0, 20 }, { 0, -20, 32 }, { 0, -40, 45 } }, 0, 1);
    auto const tree = build_branch_tree(plant);
    ProjectedSkeleton const skeleton(plant, front_view(200));
    PathSelection selection(tree);
    SelectionPen pen(skeleton, tree, selection);
    for (double z = 2; z <= 29; z += 3)
        pen.move_to({ 0, z });
    EXPECT_EQ(pen.lift(), (Paths { { 0, 1, 4 } }));
}

TEST(ProjectedSkeleton, OfTwoLinesTheNearerToTheEyeWins)
{
    Plant plant;
    add_axis(plant, { { -50, 30, 0 }, { 50, 30, 0 } });
    add_axis(plant, { { -50, 10, -20 }, { 50, 10, 20 } });
    add_axis(plant, { { -50, 40, 20 }, { 50, 40, -20 } });
    ProjectedSkeleton const skeleton(plant, front_view(100));
    EXPECT_EQ(skeleton.pick({ 0, 0 }), 1u);
    EXPECT_EQ(skeleton.pick({ -40, 0 }), 0u);
    EXPECT_EQ(skeleton.pick({ -40, 16 }), 2u);
}

TEST(ProjectedSkeleton, AFingerReachesWhatLiesBeside)
{
    Plant plant;
    add_axis(plant, { { -50, 0, 0 }, { 50, 0, 0 } });
    // The second axis is in front of the first one, but farther from the point that is picked.
    add_axis(plant, { { -50, -90, 9 }, { 50, -90, 9 } });
    ProjectedSkeleton const skeleton(plant, front_view(100));
    EXPECT_EQ(skeleton.pick({ 0, 4 }, { .line_half_width = 1, .finger = 6 }), 0u);
    EXPECT_EQ(skeleton.pick({ 0, 4 }, { .line_half_width = 1, .finger = 3 }), std::nullopt);
    EXPECT_EQ(skeleton.pick({ 60, 0 }, { .line_half_width = 1, .finger = 11 }), 0u);
}

TEST(ProjectedSkeleton, FindsWhatLookingAtAllLinesFinds)
{
    auto const plant = forking_tree(9, 3);
    ProjectedSkeleton const skeleton(plant, front_view(4000));
    Random random({ .seed = 8 });
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
        Vec2 const point(random.uniform(-1500, 1500), random.uniform(0, 3500));
        double nearest = std::numeric_limits<double>::infinity();
        for (auto const& line : skeleton.lines()) {
            Vec2 const from = line.from.cast<double>();
            Vec2 const along = line.to.cast<double>() - from;
            double const share
                = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (from + share * along - point).norm());
        }
        auto const picked = skeleton.pick(point, { .line_half_width = 0, .finger = 30 });
        EXPECT_EQ(picked.has_value(), nearest <= 30) << point.transpose();
        found += picked.has_value();
    }
    EXPECT_GT(found, 200);
}

TEST(ProjectedSkeleton, CutsWhatIsBehindTheEye)
{
    // The eye is at the origin. It looks along +y with a field of view of 90 degrees.
    Eigen::Matrix4d clip;
    clip << 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 1, 0, 0;
    Plant plant;
    // A line from behind the eye to a point in front of it.
    add_axis(plant, { { 10, -100, 0 }, { 10, 100, 0 } });
    add_axis(plant, { { 0, -5, 0 }, { 0, -9, 0 } });
    ProjectedSkeleton const skeleton(plant, view_in_pixels(clip, { 200, 200 }));
    ASSERT_EQ(skeleton.lines().size(), 1u);
    EXPECT_NEAR(skeleton.lines()[0].to.x(), 110, 1e-3);
    // The line is clipped one window width to the right of the window.
    EXPECT_NEAR(skeleton.lines()[0].from.x(), 400, 1e-3);
    EXPECT_EQ(skeleton.pick({ 150, 100 }), 0u);
    EXPECT_EQ(skeleton.pick({ 50, 100 }), std::nullopt);
}

TEST(ProjectedSkeleton, PixelsCountDownwards)
{
    ProjectedSkeleton const skeleton(pole(1, 1),
                                     view_in_pixels(front_view(1).to_plane, { 200, 100 }));
    EXPECT_EQ(skeleton.lines()[0].from, Vec2f(100, 50));
    EXPECT_EQ(skeleton.lines()[0].to, Vec2f(100, 0));
}

TEST(ProjectedSkeleton, NothingIsPickedOutsideOrOnAnEmptyPlant)
{
    ProjectedSkeleton const nothing({}, front_view(100));
    EXPECT_EQ(nothing.pick({ 0, 0 }), std::nullopt);
    ProjectedSkeleton const skeleton(pole(3, 300), front_view(100));
    EXPECT_EQ(skeleton.pick({ 0, 150 }), std::nullopt);
    double const nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(skeleton.pick({ nan, 0 }), std::nullopt);
    ProjectedSkeleton const no_window(pole(3, 300), {});
    EXPECT_EQ(no_window.pick({ 50, 50 }), std::nullopt);
}

} // namespace
} // namespace tractus::variation
