#include "engine/variation/growth.h"

#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

GrowthParameters lively()
{
    return { .growth_zone_steps = 4, .sag = 2 };
}

double length_mm(Plant const& plant)
{
    double sum = 0;
    for (auto const& axis : plant.axes)
        sum += axis_length_mm(plant, axis);
    return sum;
}

TEST(GrowthAge, IsNothingAtZeroAndTheWholePlantAtOne)
{
    auto const plant = forking_tree(5, 4);
    auto const plan = plan_of(plant, lively(), { 0.5, 0, 0 });
    Grower grower(plan);
    Plant const whole = grower.grow({ 1, 0 });
    Plant const seed = grower.grow({ 1, 0 }, 0);
    for (auto const& node : seed.node_position_mm)
        EXPECT_EQ(node, Vec3(0, 0, 0));
    for (auto const radius : seed.node_radius_mm)
        EXPECT_EQ(radius, 0);
    Plant const again = grower.grow({ 1, 0 }, 1);
    EXPECT_EQ(again.node_position_mm, whole.node_position_mm);
    EXPECT_EQ(again.node_radius_mm, plant.node_radius_mm);
    EXPECT_EQ(again.organs[3].scale, plant.organs[3].scale);
}

TEST(GrowthAge, ComesToTheWholePlantWithoutAJump)
{
    auto const plan = plan_of(forking_tree(4, 5), lively(), { 0.5, 0, 0 });
    Grower grower(plan);
    Plant const whole = grower.grow({ 1, 0 });
    auto const& nearly = grower.grow({ 1, 0 }, 0.9999);
    for (std::size_t i = 0; i < whole.node_position_mm.size(); ++i)
        EXPECT_LT((nearly.node_position_mm[i] - whole.node_position_mm[i]).norm(), 1);
    for (std::size_t i = 0; i < whole.organs.size(); ++i)
        EXPECT_NEAR(nearly.organs[i].scale.x(), whole.organs[i].scale.x(), 1e-3);
}

TEST(GrowthAge, OnlyEverAddsToWhatStands)
{
    auto const plant = forking_tree(5, 6);
    // Parameters without weight and without a growth zone.
    auto const plan = plan_of(plant, {}, { 0.5, 0, 0 });
    Grower grower(plan);
    Plant const whole = grower.grow({ 7, 3 });
    Plant before = grower.grow({ 7, 3 }, 0);
    for (double age = 0.05; age < 1; age += 0.05) {
        Plant const now = grower.grow({ 7, 3 }, age);
        check_plant(now);
        if (age < kSkeletonShare) {
            EXPECT_GT(length_mm(now), length_mm(before) + 1);
        }
        for (std::size_t i = 0; i < now.node_radius_mm.size(); ++i)
            EXPECT_GE(now.node_radius_mm[i], before.node_radius_mm[i]);
        // Parts that are fully grown must be at their final positions.
        for (auto const& axis : now.axes)
            for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
                auto const node = axis.first_node + i;
                double const grown_mm
                    = (now.node_position_mm[node + 1] - now.node_position_mm[node]).norm();
                double const full_mm
                    = (whole.node_position_mm[node + 1] - whole.node_position_mm[node]).norm();
                EXPECT_LE(grown_mm, full_mm + 1e-9);
                if (grown_mm > full_mm - 1e-9) {
                    EXPECT_LT(
                        (now.node_position_mm[node + 1] - whole.node_position_mm[node + 1]).norm(),
                        1e-9);
                }
            }
        before = now;
    }
}

TEST(GrowthAge, TheLongestWayGrowsEvenlyAndEveryTipIsReachedAtOnce)
{
    auto const plant = hand_made_plant();
    auto const ages = find_axis_ages(plant, find_rest_shape(plant));
    // Along the branches, no tip is farther from the trunk's base than the trunk's own, at 400 mm.
    EXPECT_DOUBLE_EQ(ages[0].reach_mm, 400);
    EXPECT_DOUBLE_EQ(ages[0].birth_at(200), kSkeletonShare / 2);
    EXPECT_DOUBLE_EQ(ages[1].begin, kSkeletonShare / 2);
    EXPECT_DOUBLE_EQ(ages[1].reach_mm, 150);
    EXPECT_DOUBLE_EQ(ages[2].reach_mm, 60);
    for (auto const& age : ages)
        EXPECT_DOUBLE_EQ(age.birth_at(age.reach_mm), kSkeletonShare);
    EXPECT_DOUBLE_EQ(ages[1].along_at_mm(ages[1].birth_at(37)), 37);
}

TEST(GrowthAge, LeavesUnfoldAfterTheirBranchIsThere)
{
    auto const plan = plan_of(hand_made_plant(), {});
    Grower grower(plan);
    auto const scale = [&](double age) { return grower.grow({}, age).organs[1].scale.x(); };
    EXPECT_EQ(scale(kSkeletonShare - 0.01), 0);
    EXPECT_GT(scale(0.95), 0.3);
    EXPECT_LT(scale(0.95), 0.9);
    EXPECT_EQ(scale(1), 1);
}

// Returns a tree whose only organs are leaves on its last axes.
Plant leafy_tree()
{
    auto plant = forking_tree(6, 4);
    plant.materials[0].kind = Material::Kind::Leaf;
    return plant;
}

TEST(GrowthAge, ShootsBearLeavesBeforeTheirTwigsAreThere)
{
    auto const plan = plan_of(leafy_tree(), {}, { 0.5, 0, 0 });
    Grower grower(plan);
    std::size_t before = 0;
    for (double const age : { 0.2, 0.4, 0.6, 0.8, 0.9 }) {
        auto const young = without_unborn(grower.grow({ 1, 0 }, age));
        check_plant(young);
        std::size_t shoots = 0; // Number of axes that have no laterals.
        std::vector<bool> bears(young.axes.size());
        for (auto const& axis : young.axes)
            if (axis.parent_axis != kNone)
                bears[axis.parent_axis] = true;
        for (bool const bearing : bears)
            shoots += bearing ? 0 : 1;
        EXPECT_GE(young.organs.size(), shoots) << age;
        EXPECT_GE(young.organs.size(), before) << age;
        before = young.organs.size();
        double top_mm = 0;
        for (auto const& node : young.node_position_mm)
            top_mm = std::max(top_mm, node.z());
        for (auto const& organ : young.organs) { // All organs of this plant are on branches.
            EXPECT_GE(organ.position_mm.z(), -1e-9);
            EXPECT_LE(organ.position_mm.z(), top_mm + 1e-9);
        }
    }
}

TEST(GrowthAge, YoungLeavesGoToTheirPlacesWithoutAJump)
{
    auto const plan = plan_of(leafy_tree(), {}, { 0.5, 0, 0 });
    Grower grower(plan);
    Plant const whole = grower.grow({ 1, 0 });
    Plant before = grower.grow({ 1, 0 }, 0);
    constexpr int kSteps = 2000;
    for (int i = 1; i <= kSteps; ++i) {
        Plant const now = grower.grow({ 1, 0 }, static_cast<double>(i) / kSteps);
        for (std::size_t o = 0; o < now.organs.size(); ++o) {
            EXPECT_GE(now.organs[o].scale.x(), before.organs[o].scale.x());
            // The trunk grows 5 m in 0.85 of the time, and short branches grow faster. That limits
            // the movement of an organ in one step.
            if (before.organs[o].scale.x() > 0) {
                ASSERT_LT((now.organs[o].position_mm - before.organs[o].position_mm).norm(), 12)
                    << i;
            }
        }
        before = now;
    }
    for (std::size_t o = 0; o < whole.organs.size(); ++o)
        EXPECT_EQ(before.organs[o].position_mm, whole.organs[o].position_mm);
}

TEST(WithoutUnborn, LeavesWhatHasGrownAlone)
{
    auto const base = hand_made_plant();
    auto const plan = plan_of(base, { .strength = 0 });
    Grower grower(plan);
    // At this age, the trunk is 120 mm long.
    auto const young = without_unborn(grower.grow({}, 0.3 * kSkeletonShare));
    check_plant(young);
    ASSERT_EQ(young.axes.size(), 1u);
    EXPECT_EQ(young.segment_count(), 2u);
    EXPECT_NEAR(young.node_position_mm.back().z(), 120, 1e-9);
    EXPECT_EQ(young.node_radius_mm.back(), 0);
    ASSERT_EQ(young.organs.size(), 1u); // The only organ left is the one on the ground.
    EXPECT_TRUE(young.polygons.empty());

    auto const whole = without_unborn(base);
    EXPECT_EQ(whole.node_position_mm, base.node_position_mm);
    EXPECT_EQ(whole.organs.size(), base.organs.size());
    EXPECT_EQ(whole.polygon_vertices_mm, base.polygon_vertices_mm);
    EXPECT_EQ(without_unborn(grower.grow({}, 0)).segment_count(), 0u);
}

TEST(WithoutUnborn, KeepsWhoBearsWhom)
{
    auto const plan = plan_of(forking_tree(6, 3), {});
    Grower grower(plan);
    for (double const age : { 0.2, 0.5, 0.8, 0.95 }) {
        auto const young = without_unborn(grower.grow({ 1, 0 }, age));
        check_plant(young);
        for (auto const& axis : young.axes)
            if (axis.parent_axis != kNone) {
                EXPECT_EQ(young.node_position_mm[axis.first_node],
                          young.node_position_mm[nodes_of(young, axis.parent_segment).tip]);
            }
    }
}

} // namespace
} // namespace tractus::variation
