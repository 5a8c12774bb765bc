#include "engine/variation/growth.h"
#include "engine/variation/growth_preset.h"

#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

using Steps = GrowthParameters::Steps;

Plant matured(Plant const& plant, GrowthParameters const& parameters, Vec3 const& influence)
{
    auto const plan = plan_of(plant, parameters, influence);
    return Grower(plan).grow({});
}

// Returns an axis that leaves the ground at an angle of `from_up` radians from the vertical.
Plant leaning(double from_up, int segments)
{
    Plant plant;
    Vec3 const tip(1000 * std::sin(from_up), 0, 1000 * std::cos(from_up));
    add_axis(plant, straight({ 0, 0, 0 }, tip, segments));
    return plant;
}

TEST(Maturation, EndsInTheSteadyStateOfTheLaw)
{
    // The law of Bastien et al. is tan(A / 2) = tan(A0 / 2) exp(-s / Lc), where Lc is the ratio of
    // the two rates.
    GrowthParameters const p { .steps = Steps::PerSegment,
                               .strength = 0,
                               .gain = 0,
                               .indicator_gain = 0,
                               .growth_zone_steps = 1000,
                               .maturation_bending = 0.0005,
                               .maturation_straightening = 0.02 };
    // Length of the decay, in steps; it is 40.
    double const decay_steps = p.maturation_straightening / p.maturation_bending;
    double const start = radians(89);
    auto const plant = matured(leaning(start, 200), p, { 0, 0, 1 });
    for (int const segment : { 10, 20, 50, 100, 150 }) {
        double const theory = 2 * std::atan(std::tan(start / 2) * std::exp(-segment / decay_steps));
        double const angle = std::acos(
            std::clamp(direction_of(plant, static_cast<SegmentId>(segment)).z(), -1.0, 1.0));
        EXPECT_NEAR(degrees(angle), degrees(theory), 0.02) << segment;
    }
}

TEST(Maturation, StraightensTowardsTheStrokeWithoutInfluence)
{
    GrowthParameters const fresh { .growth_zone_steps = 0 };
    GrowthParameters const matured { .growth_zone_steps = 20, .maturation_straightening = 0.2 };
    auto const roughness = [](GrowthParameters const& p) {
        auto const plan = plan_of(pole(40), p);
        Grower grower(plan);
        double sum = 0;
        for (std::uint32_t i = 0; i < 200; ++i) {
            auto const& plant = grower.grow({ 5, i });
            for (SegmentId segment = 1; segment < 40; ++segment)
                sum += (direction_of(plant, segment) - direction_of(plant, segment - 1))
                           .squaredNorm();
        }
        return sum;
    };
    EXPECT_LT(roughness(matured), 0.5 * roughness(fresh));
}

TEST(Maturation, WithoutRatesChangesNothing)
{
    GrowthParameters const p { .steps = Steps::PerSegment, .strength = 0 };
    auto still = p;
    still.growth_zone_steps = 5;
    still.maturation_bending = 0;
    still.maturation_straightening = 0;
    auto const a = matured(forking_tree(4, 6), p, { 0.4, 0, 0 });
    auto const b = matured(forking_tree(4, 6), still, { 0.4, 0, 0 });
    for (std::size_t i = 0; i < a.node_position_mm.size(); ++i)
        EXPECT_LT((a.node_position_mm[i] - b.node_position_mm[i]).norm(), 1e-6);
}

TEST(Maturation, FinerSegmentsFollowTheSameTip)
{
    GrowthParameters const p { .growth_zone_steps = 5 };
    auto const coarse = matured(pole(15), p, { 0.5, 0, 0 });
    auto const fine = matured(pole(135), p, { 0.5, 0, 0 });
    for (SegmentId segment = 0; segment < 15; ++segment)
        EXPECT_LT((direction_of(coarse, segment) - direction_of(fine, 9 * segment + 4)).norm(),
                  1e-9);
}

TEST(GrowthPreset, AllAreGrowthAndNoTwoAreAlike)
{
    auto const plant = forking_tree(5, 6);
    std::vector<Vec3> tips;
    for (auto const& preset : growth_presets()) {
        ASSERT_TRUE(check_growth_parameters(preset.parameters)) << preset.name;
        auto const varied = matured(plant, preset.parameters, { 0.2, 0, 0 });
        check_plant(varied);
        for (auto const& tip : tips)
            EXPECT_GT((tip - varied.node_position_mm.back()).norm(), 1) << preset.name;
        tips.push_back(varied.node_position_mm.back());
    }
}

TEST(GrowthPreset, AsDrawnIsAsDrawnEvenInTheWind)
{
    auto const plant = forking_tree(5, 6);
    auto const same = matured(plant, growth_preset("As-Drawn").value(), { 1, 0, 0 });
    for (std::size_t i = 0; i < plant.node_position_mm.size(); ++i)
        EXPECT_LT((same.node_position_mm[i] - plant.node_position_mm[i]).norm(), 1e-9);
}

TEST(GrowthPreset, NamesThoseThereAre)
{
    auto const none = growth_preset("hurricane");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("\"windy hillside\""), std::string::npos);
}

TEST(GrowthVariability, RunsFromAsDrawnToAsItLikes)
{
    auto const plant = forking_tree(5, 6);
    auto const usual = growth_preset("windy hillside").value();
    double last = -1;
    for (double const variability : { 0.0, 0.25, 0.5, 1.0, 2.0, 4.0 }) {
        auto const plan = plan_of(plant, at_variability(usual, variability).value(), { 0.3, 0, 0 });
        Grower grower(plan);
        double sum = 0;
        for (std::uint32_t i = 0; i < 20; ++i) {
            auto const& varied = grower.grow({ 2, i });
            for (std::size_t n = 0; n < varied.node_position_mm.size(); ++n)
                sum += (varied.node_position_mm[n] - plant.node_position_mm[n]).norm();
        }
        if (variability == 0) {
            EXPECT_LT(sum, 1e-5);
        }
        EXPECT_GT(sum, last);
        last = sum;
    }
    EXPECT_FALSE(at_variability(usual, -0.1));
    EXPECT_FALSE(at_variability(usual, 4.1));
}

} // namespace
} // namespace tractus::variation
