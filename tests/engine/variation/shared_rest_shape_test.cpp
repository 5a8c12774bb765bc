#include "engine/variation/rest_shape.h"

#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

namespace tractus::variation {
namespace {

Plant two_segments()
{
    Plant plant;
    plant.axes.push_back({ .first_node = 0, .first_segment = 0, .segment_count = 2 });
    plant.node_position_mm = { Vec3(0, 0, 0), Vec3(0, 0, 3), Vec3(0, 4, 3) };
    plant.node_radius_mm = { 1, 1, 1 };
    plant.segment_material = { 0, 0 };
    return plant;
}

TEST(SharedRestShape, IsThePlantsAndOneForAllCopies)
{
    auto const plant = std::make_shared<Plant const>(two_segments());
    SharedRestShape const rest(plant);
    auto const copy = rest;
    EXPECT_EQ(copy, rest);
    EXPECT_EQ(rest->length_mm, (std::vector<double> { 3, 4 }));
    EXPECT_EQ(rest->end_mm, (std::vector<double> { 3, 7 }));
    EXPECT_EQ(&*copy, &*rest);
    EXPECT_NE(SharedRestShape(plant), rest);
}

TEST(SharedRestShape, OfNoPlantIsEmpty)
{
    SharedRestShape const nothing;
    EXPECT_EQ(nothing, SharedRestShape());
    EXPECT_TRUE(nothing->length_mm.empty());
    EXPECT_TRUE(nothing->drawing_order.empty());
}

TEST(SharedRestShape, IsFoundOnceWhoeverAsks)
{
    SharedRestShape const rest(std::make_shared<Plant const>(two_segments()));
    std::vector<RestShape const*> found(8);
    {
        std::vector<std::jthread> threads;
        for (auto& one : found)
            threads.emplace_back([&one, &rest] { one = &*rest; });
    }
    for (auto const* one : found) {
        EXPECT_EQ(one, found.front());
        EXPECT_EQ(one->axis_length_mm, std::vector<double> { 7 });
    }
}

} // namespace
} // namespace tractus::variation
