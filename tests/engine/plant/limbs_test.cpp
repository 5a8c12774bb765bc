#include "engine/plant/limbs.h"

#include "tests/engine/plant/small_plant.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(Limbs, AreTheTrunkAndThenItsBranches)
{
    auto const result = limbs(small_plant());
    ASSERT_EQ(result.size(), 2u);
    EXPECT_EQ(result[0].path, (std::vector<SegmentId> { 0, 1, 2 }));
    EXPECT_EQ(result[0].order, 0u);
    EXPECT_DOUBLE_EQ(result[0].length_mm, 300);
    EXPECT_EQ(result[1].path, (std::vector<SegmentId> { 3, 4 }));
    EXPECT_EQ(result[1].order, 1u);
}

// A trunk of one segment that forks into a thin axis (listed first) and a thick, shorter one.
Plant forked_plant()
{
    Plant plant;
    plant.materials = { Material {} };
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
               .segment_count = 1,
               .parent_segment = 0,
               .parent_axis = 0,
               .order = 1 },
    };
    plant.node_position_mm = { { 0, 0, 0 },   { 0, 0, 10 }, { 0, 0, 10 }, { 9, 0, 10 },
                               { 18, 0, 10 }, { 0, 0, 10 }, { 0, 0, 15 } };
    plant.node_radius_mm = { 4, 4, 1, 1, 1, 3, 3 };
    plant.segment_material = { 0, 0, 0, 0 };
    check_plant(plant);
    return plant;
}

TEST(Limbs, GoOnIntoTheThickestAxisOfAFork)
{
    auto const result = limbs(forked_plant());
    ASSERT_EQ(result.size(), 2u);
    EXPECT_EQ(result[0].path, (std::vector<SegmentId> { 0, 3 }));
    EXPECT_DOUBLE_EQ(result[0].length_mm, 15);
    EXPECT_EQ(result[1].path, (std::vector<SegmentId> { 1, 2 }));
    EXPECT_EQ(result[1].order, 1u);
}

TEST(Limbs, OfOneOrderComeLongestFirst)
{
    auto plant = small_plant();
    auto const first = static_cast<NodeId>(plant.node_position_mm.size());
    plant.axes.push_back(Axis { .first_node = first,
                                .first_segment = 5,
                                .segment_count = 1,
                                .parent_segment = 1,
                                .parent_axis = 0,
                                .order = 1 });
    plant.node_position_mm.insert(plant.node_position_mm.end(), { { 0, 0, 200 }, { 0, 150, 200 } });
    plant.node_radius_mm.insert(plant.node_radius_mm.end(), { 2, 1 });
    plant.segment_material.push_back(0);
    check_plant(plant);
    auto const result = limbs(plant);
    ASSERT_EQ(result.size(), 3u);
    EXPECT_EQ(result[1].path, (std::vector<SegmentId> { 5 }));
    EXPECT_EQ(result[2].path, (std::vector<SegmentId> { 3, 4 }));
}

TEST(Limbs, OfAnEmptyPlantAreNone)
{
    EXPECT_TRUE(limbs({}).empty());
}

} // namespace
} // namespace tractus
