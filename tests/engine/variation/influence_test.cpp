#include "engine/variation/influence.h"

#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus::variation {
namespace {

// The plant is 400 mm high, and is shown at half of its size.
constexpr ShownPlant kShown { .height_mm = 200, .scale = 0.5 };

Influence influence(Plant const& plant, std::vector<MotionIndicator> const& indicators)
{
    return influence_of(plant, plant.node_position_mm, indicators, kShown).value();
}

TEST(LocalInfluence, ActsOnTheChosenBranchAndWhatItBears)
{
    auto const plant = hand_made_plant();
    auto const wind
        = influence(plant,
                    { { .start_mm = { 0, 0, 0 }, .end_mm = { 0, 100, 0 }, .below = { 4 } },
                      { .start_mm = { 0, 0, 0 }, .end_mm = { 20, 0, 0 } } });
    EXPECT_EQ(wind.everywhere, Vec3(0.1, 0, 0));
    for (SegmentId segment = 0; segment < plant.segment_count(); ++segment) {
        bool const is_below = segment >= 4 && segment <= 8;
        EXPECT_EQ(wind.local[segment], is_below ? Vec3(0, 0.5, 0) : Vec3(0, 0, 0)) << segment;
    }
}

TEST(LocalInfluence, OverlappingBranchesFeelItOnce)
{
    auto const plant = hand_made_plant();
    auto const wind = influence(
        plant, { { .start_mm = { 0, 0, 0 }, .end_mm = { 0, 100, 0 }, .below = { 7, 4, 5 } } });
    EXPECT_EQ(wind.local[8], Vec3(0, 0.5, 0));
}

TEST(LocalInfluence, FallsOffAroundWhereItWasDrawn)
{
    auto const plant = hand_made_plant();
    // The wind blows along the right branch as shown, 100 mm above the ground. So it has its full
    // effect there.
    auto const wind = influence(
        plant, { { .start_mm = { 0, 0, 100 }, .end_mm = { 75, 0, 100 }, .reach_mm = 40 } });
    EXPECT_NEAR(wind.local[5].x(), 75 / 200., 1e-12);
    // The first segment of the twig is 15 mm above the branch, shown as 7.5 mm. The share of the
    // influence there is (1 - (7.5 / 40)²)².
    double const share = 1 - std::pow(7.5 / 40, 2);
    EXPECT_NEAR(wind.local[7].x(), 75 / 200. * share * share, 1e-12);
    // This segment is shown 75 mm above the wind, beyond its reach.
    EXPECT_EQ(wind.local[3], Vec3(0, 0, 0));
    EXPECT_EQ(wind.everywhere, Vec3(0, 0, 0));
}

TEST(LocalInfluence, LightDrawsEveryBranchTowardsItself)
{
    auto const plant = hand_made_plant();
    MotionIndicator lamp { .start_mm = { 300, 0, 100 }, .end_mm = { 100, 0, 100 } };
    lamp.kind = MotionIndicator::Kind::Light;
    auto const light = influence(plant, { lamp });
    for (SegmentId segment = 0; segment < plant.segment_count(); ++segment)
        EXPECT_NEAR(light.local[segment].norm(), 1, 1e-12);
    // A branch on the left of the light bends to the right.
    EXPECT_GT(light.local[10].normalized().x(), 0.9);
    EXPECT_LT(light.local[3].z(), -0.4); // A branch above the light bends down.
    EXPECT_GT(light.local[0].z(), 0.4);  // A branch below the light bends up.
}

TEST(LocalInfluence, BendsTheBranchesThatItActsOnAndNoOther)
{
    GrowthJob job { .plant = hand_made_plant(),
                    .shown_height_mm = kShown.height_mm,
                    .scale = kShown.scale,
                    .parameters = { .strength = 0 } };
    job.indicators = { { .start_mm = { 0, 0, 0 }, .end_mm = { 0, 200, 0 }, .below = { 4 } } };
    auto const plant = grow(job).value();
    for (SegmentId const still : { 0u, 1u, 2u, 3u, 9u, 10u })
        EXPECT_NEAR(direction_of(plant, still).y(), 0, 1e-12) << still;
    for (SegmentId const pushed : { 4u, 5u, 6u, 7u, 8u })
        EXPECT_GT(direction_of(plant, pushed).y(), 0.05) << pushed;
}

TEST(LocalInfluence, OnTheWholePlantIsTheSameAsEverywhere)
{
    GrowthJob job { .plant = forking_tree(5, 5), .shown_height_mm = 250 };
    job.indicators = { { .start_mm = { 0, 0, 0 }, .end_mm = { 100, 50, 0 } } };
    auto const everywhere = grow(job).value();
    job.indicators[0].below = { 0 };
    auto const below_the_trunk = grow(job).value();
    for (std::size_t i = 0; i < everywhere.node_position_mm.size(); ++i)
        EXPECT_LT((everywhere.node_position_mm[i] - below_the_trunk.node_position_mm[i]).norm(),
                  1e-9);
}

TEST(LocalInfluence, RefusesWhatHasNoPlaceOrReach)
{
    auto const plant = hand_made_plant();
    auto const error = [&](MotionIndicator const& indicator, ShownPlant const& shown = kShown) {
        return influence_of(plant, plant.node_position_mm, { &indicator, 1 }, shown)
            .error()
            .message;
    };
    EXPECT_EQ(error({ .reach_mm = 0 }),
              "the motion indicator reaches 0 mm: give it a reach above 0 mm");
    EXPECT_EQ(error({ .below = { 11 } }),
              "the motion indicator acts on segment 11, which is not in the plant of 11: select "
              "the branch again");
    EXPECT_EQ(error({ .end_mm = Vec3::Constant(std::numeric_limits<double>::quiet_NaN()) }),
              "an end of the motion indicator is not a number: draw it again");
    EXPECT_NE(error({}, {}).find("show it above 0 mm"), std::string::npos);
}

TEST(NearestIndicator, IsTheOneWhoseLineIsUnderTheFinger)
{
    std::vector<MotionIndicator> const two { { { 0, 0, 0 }, { 100, 0, 0 } },
                                             { { 0, 0, 30 }, { 100, 0, 30 } } };
    EXPECT_EQ(nearest_indicator(two, { 50, 0, 10 }, 15), std::optional<std::size_t>(0));
    EXPECT_EQ(nearest_indicator(two, { 50, 5, 28 }, 15), std::optional<std::size_t>(1));
    EXPECT_FALSE(nearest_indicator(two, { 150, 0, 0 }, 15));
}

} // namespace
} // namespace tractus::variation
