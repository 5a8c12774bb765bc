#include "engine/plant/tree_measures.h"

#include "engine/plant/pipe_model.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

// Adds an axis of one segment to another axis. Then adds two axes to its end, recursively, down to
// the given depth.
void add_forks(Plant& plant, AxisId parent, Vec3 const& foot_mm, double length_mm, double aside_mm,
               int depth)
{
    auto const number = static_cast<AxisId>(plant.axes.size());
    bool const is_root = parent == kNone;
    plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                           .first_segment = static_cast<SegmentId>(plant.segment_count()),
                           .segment_count = 1,
                           .parent_segment = is_root ? kNone : plant.axes[parent].first_segment,
                           .parent_axis = parent,
                           .order = is_root ? 0 : plant.axes[parent].order + 1 });
    Vec3 const tip_mm = foot_mm + Vec3(aside_mm, 0, length_mm);
    plant.node_position_mm.insert(plant.node_position_mm.end(), { foot_mm, tip_mm });
    plant.node_radius_mm.insert(plant.node_radius_mm.end(), { 1, 1 });
    plant.segment_material.push_back(0);
    for (double const side : { -1.0, 1.0 })
        if (depth > 1)
            add_forks(plant, number, tip_mm, length_mm / 2, side * length_mm / 8, depth - 1);
}

Plant forked_plant(int depth)
{
    Plant plant;
    plant.materials.resize(1);
    add_forks(plant, kNone, Vec3::Zero(), 4000, 0, depth);
    return plant;
}

TEST(TreeMeasures, HortonsRatiosOfATreeThatForksEvenly)
{
    auto plant = forked_plant(6);
    apply_pipe_model(plant, 2.5, 2);
    check_plant(plant);
    auto const measures = measure_tree(plant);
    EXPECT_EQ(measures.internodes, 63U);
    EXPECT_EQ(measures.strahler, 6);
    EXPECT_NEAR(measures.bifurcation_ratio, 2, 1e-9);
    // The lateral branches lean slightly, so the ratio is not exact.
    EXPECT_NEAR(measures.length_ratio, 2, 0.05);
    EXPECT_NEAR(measures.pipe_exponent, 2.5, 0.002);
    EXPECT_NEAR(measures.height_mm, 4000 * (2 - 1.0 / 32), 1e-9);
    EXPECT_NEAR(measures.breast_diameter_mm, 2 * plant.node_radius_mm[0], 1e-9);
    EXPECT_NEAR(measures.slenderness, measures.height_mm / measures.breast_diameter_mm, 1e-9);
}

TEST(TreeMeasures, AStemHasNoRatios)
{
    auto const measures = measure_tree(forked_plant(1));
    EXPECT_EQ(measures.strahler, 1);
    EXPECT_EQ(measures.bifurcation_ratio, 0);
    EXPECT_EQ(measures.length_ratio, 0);
    EXPECT_EQ(measures.pipe_exponent, 0);
    EXPECT_EQ(measures.height_mm, 4000);
}

TEST(TreeMeasures, NothingIsMeasuredOfNothing)
{
    EXPECT_EQ(measure_tree({}).internodes, 0U);
    EXPECT_EQ(measure_tree({}).height_mm, 0);
}

} // namespace
} // namespace tractus
