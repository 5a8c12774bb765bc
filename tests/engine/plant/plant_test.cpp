#include "engine/plant/plant.h"

#include "tests/engine/plant/small_plant.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(Plant, FindsTheAxisOfASegment)
{
    auto const plant = small_plant();
    EXPECT_EQ(axis_of(plant, 0), 0u);
    EXPECT_EQ(axis_of(plant, 2), 0u);
    EXPECT_EQ(axis_of(plant, 3), 1u);
    EXPECT_EQ(axis_of(plant, 4), 1u);
}

TEST(Plant, FindsTheNodesOfASegment)
{
    auto const plant = small_plant();
    EXPECT_EQ(nodes_of(plant, 2).base, 2u);
    EXPECT_EQ(nodes_of(plant, 2).tip, 3u);
    EXPECT_EQ(nodes_of(plant, 3).base, 4u);
}

TEST(Plant, ParentOfAnAxisIsWhatItStandsOn)
{
    auto const plant = small_plant();
    EXPECT_EQ(parent_segment(plant, 0), kNone);
    EXPECT_EQ(parent_segment(plant, 2), 1u);
    EXPECT_EQ(parent_segment(plant, 3), 0u);
}

TEST(Plant, BoundsHoldAllNodes)
{
    auto const box = bounds(small_plant());
    EXPECT_EQ(box.min_mm, Vec3(0, 0, 0));
    EXPECT_EQ(box.max_mm, Vec3(100, 0, 300));
    EXPECT_TRUE(bounds({}).empty());
}

TEST(Plant, MeasuresAnAxisAlongItsSegments)
{
    auto const plant = small_plant();
    EXPECT_DOUBLE_EQ(axis_length_mm(plant, plant.axes[0]), 300);
}

TEST(PlantDeathTest, CheckFindsAnAxisOnASegmentThatIsNotItsParents)
{
    auto plant = small_plant();
    check_plant(plant);
    plant.axes[1].parent_segment = 4;
    EXPECT_DEATH(check_plant(plant), "CHECK");
}

} // namespace
} // namespace tractus
