#include "engine/variation/growth_sag.h"

#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

// Returns a rod that is clamped at one end and does not touch the ground.
Plant rod(Vec3 const& tip, int segments, float radius_mm)
{
    Plant plant;
    add_axis(plant, straight({ 0, 0, 2000 }, Vec3(0, 0, 2000) + tip, segments));
    std::fill(plant.node_radius_mm.begin(), plant.node_radius_mm.end(), radius_mm);
    return plant;
}

Plant sagged(Plant const& plant, double sag)
{
    auto const plan = plan_of(plant, { .strength = 0, .sag = sag });
    return Grower(plan).grow({});
}

// Returns the deflection of a horizontal rod of green wood under its own weight. By beam theory, it
// is q l⁴ / (8 E I).
double theory_mm(double length_mm, double radius_mm)
{
    double const per_length = 1000e-9 * 9.81 * kPi * radius_mm * radius_mm;
    double const stiffness = 6000 * kPi / 4 * std::pow(radius_mm, 4);
    return per_length * std::pow(length_mm, 4) / (8 * stiffness);
}

TEST(Sag, IsThatOfARodUnderItsWeight)
{
    for (float const radius_mm : { 4.f, 8.f }) {
        auto const plant = sagged(rod({ 1000, 0, 0 }, 100, radius_mm), 1);
        double const drop_mm = 2000 - plant.node_position_mm.back().z();
        EXPECT_NEAR(drop_mm, theory_mm(1000, radius_mm), 0.01 * theory_mm(1000, radius_mm));
    }
}

TEST(Sag, HardlyDependsOnHowFineTheSegmentsAre)
{
    auto const drop_mm = [](int segments) {
        return 2000 - sagged(rod({ 1000, 0, 0 }, segments, 4), 1).node_position_mm.back().z();
    };
    EXPECT_NEAR(drop_mm(10), drop_mm(200), 0.06 * drop_mm(200));
}

TEST(Sag, OfALongSoftRodEndsHangingDownAndKeepsItsLength)
{
    auto const plant = sagged(rod({ 1000, 200, 300 }, 50, 4), 1e6);
    check_plant(plant);
    EXPECT_NEAR(axis_length_mm(plant, plant.axes[0]), Vec3(1000, 200, 300).norm(), 1e-6);
    for (SegmentId segment = 1; segment < 50; ++segment)
        EXPECT_LT(direction_of(plant, segment).z(), -0.99) << segment;
}

TEST(Sag, LeavesAnUprightPoleAndAHangingOneAlone)
{
    for (double const z : { 1000.0, -1000.0 }) {
        auto const base = rod({ 0, 0, z }, 20, 2);
        EXPECT_LT((sagged(base, 100).node_position_mm.back() - base.node_position_mm.back()).norm(),
                  1e-9);
    }
}

TEST(Sag, IsGivenUpWhenAskedTo)
{
    auto const plant = rod({ 1000, 0, 0 }, 10, 10);
    auto const plan = plan_of(plant, { .strength = 0, .sag = 1 });
    auto frames = plan.parent_frame;
    auto hanging = plant;
    SagSimulator sagger(plan);
    std::stop_source asked;
    asked.request_stop();
    sagger.sag(hanging, frames, asked.get_token());
    EXPECT_EQ(hanging.node_position_mm, plant.node_position_mm);
    sagger.sag(hanging, frames);
    EXPECT_EQ(hanging.node_position_mm, sagged(plant, 1).node_position_mm);
}

TEST(Sag, BranchesWeighOnWhatBearsThem)
{
    auto const drop_mm = [](bool with_twig) {
        auto plant = rod({ 1000, 0, 0 }, 20, 8);
        if (with_twig)
            add_axis(plant, straight({ 1000, 0, 2000 }, { 1000, 0, 2300 }, 5), 0, 19);
        std::fill(plant.node_radius_mm.begin(), plant.node_radius_mm.end(), 8.f);
        auto const bent = sagged(plant, 1);
        return 2000 - bent.node_position_mm[20].z();
    };
    EXPECT_GT(drop_mm(true), 1.5 * drop_mm(false));
}

TEST(Sag, CarriesWhatRidesOnTheBranches)
{
    auto const base = hand_made_plant();
    auto const plan = plan_of(base, { .strength = 0, .sag = 3000 });
    Grower grower(plan);
    auto const& plant = grower.grow({});
    check_plant(plant);
    EXPECT_GT(direction_of(base, 6).z() - direction_of(plant, 6).z(), 0.05);
    EXPECT_EQ(plant.organs[0].position_mm, plant.positions(plant.axes[2]).back());
    // The organ pointed along the twig, and must still do so.
    Vec3 const up = plant.organs[0].orientation * Vec3::UnitZ();
    EXPECT_LT((up - direction_of(plant, 8)).norm(), 1e-9);
}

TEST(Sag, OfSegmentsWithoutThicknessOrLengthIsStillAPlant)
{
    auto plant = hand_made_plant();
    std::fill(plant.node_radius_mm.begin(), plant.node_radius_mm.begin() + 6, 0.f);
    plant.node_position_mm[2] = plant.node_position_mm[1];
    check_plant(sagged(plant, 5));
    check_plant(sagged(pole(3, 0), 5));
}

} // namespace
} // namespace tractus::variation
