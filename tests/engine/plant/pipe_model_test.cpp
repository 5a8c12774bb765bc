#include "engine/plant/pipe_model.h"

#include "tests/engine/plant/small_plant.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus {
namespace {

double radius(Plant const& plant, NodeId node)
{
    return static_cast<double>(plant.node_radius_mm[node]);
}

TEST(PipeModel, ConservesWoodAtTheFork)
{
    for (double const exponent : { 1.8, 2.0, 2.3, 3.0 }) {
        auto plant = small_plant();
        apply_pipe_model(plant, exponent, 1.5);
        check_plant(plant);
        // The first segment of the trunk carries its second segment and the lateral axis.
        double const sum
            = std::pow(radius(plant, 1), exponent) + std::pow(radius(plant, 4), exponent);
        EXPECT_NEAR(std::pow(radius(plant, 0), exponent), sum, 1e-5 * sum);
        EXPECT_FLOAT_EQ(plant.node_radius_mm[3], 1.5f);
        EXPECT_FLOAT_EQ(plant.node_radius_mm[6], 1.5f);
    }
}

TEST(PipeModel, KeepsTheRadiusUpToATerminalFork)
{
    auto plant = small_plant();
    plant.axes[1].parent_segment = 2; // The lateral axis now begins at the tip of the trunk.
    auto second = plant.axes[1];
    second.first_node = 7;
    second.first_segment = 5;
    plant.axes.push_back(second);
    plant.node_position_mm.insert(plant.node_position_mm.end(),
                                  { { 0, 0, 300 }, { 0, 9, 300 }, { 0, 19, 300 } });
    plant.node_radius_mm.insert(plant.node_radius_mm.end(), 3, 0);
    plant.segment_material.insert(plant.segment_material.end(), 2, 0);
    apply_pipe_model(plant, 2, 1);
    check_plant(plant);
    for (NodeId node = 0; node <= 3; ++node)
        EXPECT_FLOAT_EQ(plant.node_radius_mm[node], std::sqrt(2.0f));
}

TEST(PipeModel, NeverFallsTowardsTheBase)
{
    auto plant = small_plant();
    apply_pipe_model(plant, 2, 1);
    for (auto const& axis : plant.axes)
        for (NodeId node = axis.first_node; node < axis.first_node + axis.segment_count; ++node)
            EXPECT_GE(plant.node_radius_mm[node], plant.node_radius_mm[node + 1]);
}

} // namespace
} // namespace tractus
