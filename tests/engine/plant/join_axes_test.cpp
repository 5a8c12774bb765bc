#include "engine/plant/join_axes.h"

#include "tests/engine/plant/small_plant.h"

#include <gtest/gtest.h>
#include <utility>

namespace tractus {
namespace {

// Returns a trunk of one segment that forks into a thin axis, which is listed first, and a shorter,
// thick axis. The thick axis has a twig with a leaf.
Plant forked_plant()
{
    Plant plant;
    plant.materials = { Material {} };
    plant.organ_shapes = { OrganShape {} };
    plant.axes = {
        Axis { .first_node = 0, .first_segment = 0, .segment_count = 1 },
        Axis { .first_node = 2,
               .first_segment = 1,
               .segment_count = 2,
               .parent_segment = 0,
               .parent_axis = 0,
               .order = 1 },
        Axis { .first_node = 5,
               .first_segment = 3,
               .segment_count = 2,
               .parent_segment = 0,
               .parent_axis = 0,
               .order = 1 },
        Axis { .first_node = 8,
               .first_segment = 5,
               .segment_count = 1,
               .parent_segment = 3,
               .parent_axis = 2,
               .order = 2 },
    };
    plant.node_position_mm
        = { { 0, 0, 0 },  { 0, 0, 10 }, { 0, 0, 10 }, { 9, 0, 10 }, { 18, 0, 10 },
            { 0, 0, 10 }, { 0, 0, 15 }, { 0, 0, 20 }, { 0, 0, 15 }, { 0, 4, 15 } };
    plant.node_radius_mm = { 4, 4, 1, 1, 1, 3, 3, 2, 1, 1 };
    plant.segment_material = { 0, 0, 0, 0, 0, 0 };
    plant.organs = { Organ { .segment = 5, .position_mm = { 0, 4, 15 } } };
    check_plant(plant);
    return plant;
}

TEST(JoinAxes, GoesOnIntoTheThickestAxisOfAFork)
{
    auto const plant = join_axes(forked_plant());
    check_plant(plant);
    ASSERT_EQ(plant.axes.size(), 3u);
    EXPECT_EQ(plant.axes[0].segment_count, 3u);
    EXPECT_EQ(plant.positions(plant.axes[0]).back(), Vec3(0, 0, 20));
    // The shared node has the radius of the axis that begins there.
    EXPECT_EQ(plant.node_radius_mm[1], 3);
}

TEST(JoinAxes, CountsOrdersAnew)
{
    auto const plant = join_axes(forked_plant());
    EXPECT_EQ(plant.axes[1].order, 1u);
    EXPECT_EQ(plant.axes[2].order, 1u); // The twig is now a branch of the trunk.
    EXPECT_EQ(plant.axes[2].parent_axis, 0u);
}

TEST(JoinAxes, KeepsWhatRidesOnEachSegment)
{
    auto const plant = join_axes(forked_plant());
    ASSERT_EQ(plant.organs.size(), 1u);
    auto const nodes = nodes_of(plant, plant.organs[0].segment);
    EXPECT_EQ(plant.node_position_mm[nodes.tip], plant.organs[0].position_mm);
}

TEST(JoinAxes, OfEquallyThickAxesTheStraightestGoesOn)
{
    auto forked = forked_plant();
    forked.node_radius_mm[2] = 3;
    EXPECT_EQ(join_axes(forked).positions(join_axes(forked).axes[0]).back(), Vec3(0, 0, 20));
}

TEST(JoinAxes, LeavesAPlantWithoutForksAlone)
{
    auto const before = small_plant();
    auto const after = join_axes(before);
    EXPECT_EQ(after.axes.size(), before.axes.size());
    EXPECT_EQ(after.node_position_mm, before.node_position_mm);
    EXPECT_TRUE(join_axes({}).axes.empty());
}

TEST(JoinAxes, CopiesNothingWhereNothingIsToBeJoined)
{
    auto plant = small_plant();
    auto const* const nodes = plant.node_position_mm.data();
    EXPECT_EQ(join_axes(std::move(plant)).node_position_mm.data(), nodes);
}

// Axes that are listed in a wrong order must get new numbers and correct branching orders.
TEST(JoinAxes, NumbersAnewWhatIsOutOfOrder)
{
    auto plant = small_plant();
    for (auto& axis : plant.axes)
        axis.order += 3;
    auto const joined = join_axes(plant);
    auto const sound = small_plant();
    ASSERT_EQ(joined.axes.size(), sound.axes.size());
    for (std::size_t i = 0; i < sound.axes.size(); ++i)
        EXPECT_EQ(joined.axes[i].order, sound.axes[i].order) << i;
}

TEST(JoinAxes, LeavesAGapOpen)
{
    auto forked = forked_plant();
    for (NodeId node = 5; node < 8; ++node)
        forked.node_position_mm[node].x() += 1;
    for (NodeId node = 2; node < 5; ++node)
        forked.node_position_mm[node].y() += 1;
    EXPECT_EQ(join_axes(forked).axes.size(), 4u);
}

TEST(DrawingOrder, IsTrunkFirstThenTheLongestOfEachOrder)
{
    auto plant = small_plant();
    plant.axes.push_back(Axis { .first_node = 7,
                                .first_segment = 5,
                                .segment_count = 1,
                                .parent_segment = 1,
                                .parent_axis = 0,
                                .order = 1 });
    plant.node_position_mm.insert(plant.node_position_mm.end(), { { 0, 0, 200 }, { 0, 150, 200 } });
    plant.node_radius_mm.insert(plant.node_radius_mm.end(), { 2, 1 });
    plant.segment_material.push_back(0);
    check_plant(plant);
    EXPECT_EQ(axes_in_drawing_order(plant), (std::vector<AxisId> { 0, 2, 1 }));
    EXPECT_EQ(segments_of(plant.axes[1]), (std::vector<SegmentId> { 3, 4 }));
}

} // namespace
} // namespace tractus
