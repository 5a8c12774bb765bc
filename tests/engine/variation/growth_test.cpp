#include "engine/variation/growth.h"

#include "engine/stroke/resample.h"
#include "engine/variation/growth_bundle.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <cstring>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace tractus::variation {
namespace {

GrowthParameters quiet()
{
    return { .strength = 0 };
}

TEST(GrowthPlan, IsWithoutSegmentsWhenItIsGivenUp)
{
    auto const plant = forking_tree(3, 4);
    auto const rest = find_rest_shape(plant);
    PredefinedShape const shape { rest.frame };
    std::stop_source asked;
    EXPECT_EQ(plan_growth(plant, rest, shape, {}, {}, asked.get_token()).value().segments.size(),
              plant.segment_count());
    asked.request_stop();
    EXPECT_TRUE(
        plan_growth(plant, rest, shape, {}, {}, asked.get_token()).value().segments.empty());
}

// True if two vectors of trivially copyable elements are equal, byte by byte.
template<typename T> bool same_bytes(std::vector<T> const& a, std::vector<T> const& b)
{
    return a.size() == b.size()
        && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_plant(Plant const& a, Plant const& b)
{
    for (std::size_t i = 0; i < a.organs.size(); ++i)
        if (a.organs[i].position_mm != b.organs[i].position_mm
            || a.organs[i].orientation.coeffs() != b.organs[i].orientation.coeffs())
            return false;
    return same_bytes(a.node_position_mm, b.node_position_mm)
        && same_bytes(a.polygon_vertices_mm, b.polygon_vertices_mm);
}

Plant grown(Plant const& plant, GrowthParameters const& parameters, PlantKey const& key,
            Vec3 const& influence = Vec3::Zero())
{
    auto const plan = plan_of(plant, parameters, influence);
    return Grower(plan).grow(key);
}

TEST(Growth, WithoutNoiseAndIndicatorsGivesTheBasePlant)
{
    auto const plant = forking_tree(8, 5);
    auto const same = grown(plant, quiet(), {});
    for (std::size_t i = 0; i < plant.node_position_mm.size(); ++i)
        EXPECT_LT((same.node_position_mm[i] - plant.node_position_mm[i]).norm(), 1e-9);
}

TEST(Growth, TurnsCrossSectionsWithTheirAxes)
{
    Plant plant;
    add_axis(plant, straight({ 0, 0, 0 }, { 0, 0, 100 }, 8));
    Contour contour;
    contour.points.assign(Contour::kSteps + 1, Vec3f::UnitX());
    plant.contours = { contour };
    NodeSection section;
    section.contour = 0;
    section.normal = Vec3f::UnitX();
    plant.node_section.assign(plant.node_position_mm.size(), section);
    auto const bent = grown(plant, {}, { .seed = 3 }, Vec3(0.8, 0.3, 0));
    check_plant(bent);
    double turned = 0;
    for (std::size_t i = 0; i + 1 < bent.node_position_mm.size(); ++i) {
        Vec3 const along = (bent.node_position_mm[i + 1] - bent.node_position_mm[i]).normalized();
        auto const& normal = bent.node_section[i].normal;
        EXPECT_NEAR(along.dot(normal.cast<double>()), 0, 1e-6);
        EXPECT_NEAR(normal.norm(), 1, 1e-6);
        turned = std::max<double>(turned, (normal - Vec3f::UnitX()).norm());
    }
    EXPECT_GT(turned, 0.02);
}

TEST(Growth, WithoutNoiseAndIndicatorsGivesTheStrokeBack)
{
    auto const drawn = s_curve(61);
    Plant plant;
    std::vector<Vec3> nodes { { 0, 0, 0 } };
    // The segments are three times as long as those of the stroke.
    for (std::size_t i = 1; i < drawn.size(); ++i)
        nodes.push_back(nodes.back() + Vec3(0, 0, 3 * (drawn[i] - drawn[i - 1]).norm()));
    add_axis(plant, nodes);
    GrowthJob job { .plant = plant, .parameters = quiet() };
    job.associations.push_back({ .path = {}, .stroke = stroke_of(drawn) });
    for (SegmentId segment = 0; segment < 60; ++segment)
        job.associations[0].path.push_back(segment);

    auto const bent = grow(job).value();
    // The stroke starts nearly vertically. Here it is rotated so that its start is vertical.
    ArcLength const curve(drawn);
    auto const turn = least_rotation((curve.at(0.05) - curve.at(0)).normalized(), Vec3::UnitZ());
    for (SegmentId segment = 0; segment < 60; ++segment) {
        Vec3 const meant = turn * (drawn[segment + 1] - drawn[segment]).normalized();
        EXPECT_LT((direction_of(bent, segment) - meant).norm(), 1e-12);
        EXPECT_LT((bent.node_position_mm[segment + 1] - 3 * (turn * drawn[segment + 1])).norm(),
                  1e-9);
    }
}

TEST(Growth, KeepsTopologyLengthsAndRadii)
{
    auto const plant = hand_made_plant();
    auto const varied = grown(plant, { .strength = 3 }, { .seed = 5 }, { 2, 0, 0.5 });
    check_plant(varied);
    EXPECT_TRUE(same_bytes(varied.axes, plant.axes));
    EXPECT_EQ(varied.node_radius_mm, plant.node_radius_mm);
    EXPECT_EQ(varied.segment_material, plant.segment_material);
    for (auto const& axis : plant.axes) {
        auto const before = plant.positions(axis);
        auto const after = varied.positions(axis);
        for (std::size_t i = 1; i < before.size(); ++i) {
            double const length_mm = (before[i] - before[i - 1]).norm();
            EXPECT_NEAR((after[i] - after[i - 1]).norm(), length_mm, 1e-12 * length_mm);
        }
    }
    EXPECT_GT((varied.node_position_mm[4] - plant.node_position_mm[4]).norm(), 1);
}

TEST(Growth, AxesStayWhereTheyStand)
{
    auto const varied = grown(forking_tree(6, 3), { .strength = 3 }, { .seed = 5 }, { 1, 0, 0 });
    for (auto const& axis : varied.axes) {
        if (axis.parent_segment == kNone)
            continue;
        auto const seat = varied.node_position_mm[nodes_of(varied, axis.parent_segment).tip];
        EXPECT_EQ(varied.node_position_mm[axis.first_node], seat);
    }
}

TEST(Growth, OrgansAndPolygonsRideOnTheirSegments)
{
    auto const plant = hand_made_plant();
    auto const varied = grown(plant, { .strength = 3 }, { .seed = 5 }, { 1, 0, 0 });
    EXPECT_EQ(varied.organs[0].position_mm, varied.positions(varied.axes[2]).back());
    EXPECT_NEAR((varied.organs[1].position_mm - varied.node_position_mm[4]).norm(), 5, 1e-12);
    EXPECT_EQ(varied.organs[2].position_mm, plant.organs[2].position_mm);
    // The organ must have turned with its segment.
    Vec3 const up = varied.organs[1].orientation * Vec3::UnitZ();
    EXPECT_LT((up - direction_of(varied, 3)).norm(), 1e-12);

    auto const& corners = varied.polygon_vertices_mm;
    EXPECT_LT((corners[0] - varied.positions(varied.axes[3]).back()).norm(), 1e-12);
    EXPECT_LT((corners[1] - corners[0] - 10 * direction_of(varied, 10)).norm(), 1e-11);
    EXPECT_NEAR((corners[2] - corners[0]).dot(corners[1] - corners[0]), 0, 1e-10);
}

TEST(Growth, SectionsThatAreNotRoundTurnWithTheirSegments)
{
    auto plant = hand_made_plant();
    plant.contours.resize(1);
    plant.contours[0].points.resize(Contour::kSteps + 1, Vec3f::UnitX());
    plant.node_section.resize(plant.node_position_mm.size());
    for (auto const& axis : plant.axes)
        for (std::uint32_t i = 0; i <= axis.segment_count; ++i)
            // The normal of each section is y, which is perpendicular to all axes of this plant.
            plant.node_section[axis.first_node + i] = { .contour = 0, .normal = Vec3f::UnitY() };
    auto const varied = grown(plant, { .strength = 3, .sag = 50 }, { .seed = 5 }, { 2, 1, 0.5 });
    check_plant(varied);
    for (auto const& axis : varied.axes)
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto const& normal = varied.node_section[axis.first_node + i].normal;
            EXPECT_NEAR(normal.norm(), 1, 1e-5);
            Vec3 const along = direction_of(varied, axis.first_segment + i);
            EXPECT_NEAR(normal.cast<double>().dot(along), 0, 1e-5);
        }
    auto const young = without_unborn(varied);
    EXPECT_EQ(young.node_section.size(), young.node_position_mm.size());
}

TEST(Growth, SameKeySameBytesOtherKeysOthers)
{
    auto const plant = forking_tree(5, 4);
    auto const first = grown(plant, {}, { .seed = 1, .plant_index = 7 });
    EXPECT_TRUE(same_plant(first, grown(plant, {}, { .seed = 1, .plant_index = 7 })));
    EXPECT_FALSE(same_plant(first, grown(plant, {}, { .seed = 2, .plant_index = 7 })));
    EXPECT_FALSE(same_plant(first, grown(plant, {}, { .seed = 1, .plant_index = 8 })));
}

TEST(Growth, AGrowerLeavesNothingOfThePlantBefore)
{
    auto const plant = hand_made_plant();
    auto const plan = plan_of(plant, {});
    Grower grower(plan);
    Plant const first = grower.grow({ .seed = 1 });
    EXPECT_FALSE(same_plant(first, grower.grow({ .seed = 2 })));
    EXPECT_TRUE(same_plant(first, grower.grow({ .seed = 1 })));
}

TEST(Growth, DoesNotDependOnTheNumberOfThreads)
{
    auto const plant = forking_tree(12, 8);
    auto const plan = plan_of(plant, {}, { 0.5, 0.2, 0 });
    tbb::global_control const allow(tbb::global_control::max_allowed_parallelism, 4);
    Plant one;
    for (int const threads : { 1, 2, 4 }) {
        tbb::task_arena arena(threads);
        Plant const varied = arena.execute([&] { return Grower(plan).grow({ .seed = 3 }); });
        if (threads == 1)
            one = varied;
        else
            EXPECT_TRUE(same_plant(varied, one)) << threads << " threads";
    }
}

// Returns a plant of forty axes with 1 to 11 segments. Each axis except the first is a lateral of
// another one.
Plant uneven_tree()
{
    Plant plant;
    for (int number = 0; number < 40; ++number) {
        auto const parent = number == 0 ? kNone : static_cast<AxisId>((number - 1) / 3);
        SegmentId segment = kNone;
        Vec3 base = Vec3::Zero();
        if (parent != kNone) {
            auto const& axis = plant.axes[parent];
            segment = axis.first_segment + static_cast<SegmentId>(number) % axis.segment_count;
            base = plant.node_position_mm[nodes_of(plant, segment).tip];
        }
        Vec3 const step(20.0 * (number % 3 - 1), 15.0 * (number % 5 - 2), 60);
        add_axis(plant, straight(base, base + step, 1 + number * 7 % 11), parent, segment);
    }
    return plant;
}

TEST(Growth, AxesSideBySideGrowAsTheyWouldAlone)
{
    GrowthParameters const wild { .strength = 30, .circumnutation_rad = 0.1 };
    GrowthParameters const late { .delay_steps = 1, .growth_zone_steps = 3 };
    for (auto const& parameters : { GrowthParameters {}, wild, late })
        for (double const age : { 0.4, 1.0 }) {
            auto const plan = plan_of(uneven_tree(), parameters, { 2, 0, -1 });
            GrowthNoise const noise({ .seed = 8 });
            auto alone = plan.base.node_position_mm;
            std::vector<Quat> frames(plan.parent_frame.size());
            GrowthBundle bundle(plan, noise, age, { alone, frames });
            for (AxisId id = 0; id < plan.base.axes.size(); ++id)
                bundle.grow(std::span(&id, 1));
            Grower grower(plan);
            EXPECT_TRUE(same_bytes(grower.grow({ .seed = 8 }, age).node_position_mm, alone));
        }
}

TEST(Growth, WhatGrowsElsewhereChangesNothingOfABranch)
{
    auto plant = hand_made_plant();
    auto const before = grown(plant, {}, { .seed = 4 });
    // Changes the shape of the left branch.
    plant.node_position_mm[plant.axes[3].first_node + 2] = { -100, 50, 300 };
    auto const after = grown(plant, {}, { .seed = 4 });
    for (NodeId node = 0; node < plant.axes[3].first_node; ++node)
        EXPECT_EQ(after.node_position_mm[node], before.node_position_mm[node]);
}

TEST(Growth, RefusesIndicatorsWithoutAHeightToMeasureThemBy)
{
    GrowthJob job { .plant = pole(3) };
    job.indicators.push_back({ .start_mm = { 0, 0, 0 }, .end_mm = { 1, 0, 0 } });
    auto const plant = grow(job);
    ASSERT_FALSE(plant);
    EXPECT_EQ(plant.error().message,
              "the motion indicators are measured against a plant shown 0 mm "
              "high: show it above 0 mm");
}

TEST(Growth, AnEmptyPlantStaysEmpty)
{
    EXPECT_EQ(grow({}).value().segment_count(), 0u);
}

} // namespace
} // namespace tractus::variation
