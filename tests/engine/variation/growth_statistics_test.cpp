#include "engine/variation/growth.h"

#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

using Steps = GrowthParameters::Steps;

Plant grown_freely(Plant const& plant, GrowthParameters const& parameters,
                   Vec3 const& influence = Vec3::Zero())
{
    auto const plan = plan_of(plant, parameters, influence);
    return Grower(plan).grow({});
}

double tilt_deg(Plant const& plant, SegmentId segment)
{
    return degrees(std::acos(std::clamp(direction_of(plant, segment).z(), -1.0, 1.0)));
}

// Returns parameters of a law with a step for each segment, whose only noise is independent from
// step to step.
GrowthParameters white_noise(double gain, double noise_rad)
{
    return { .steps = Steps::PerSegment, .gain = gain, .noise_rad = noise_rad, .noise_memory = 0 };
}

// Returns the variance of one component of the deviation of a segment on a vertical axis, as the
// mean over many plants.
double variance(GrowthPlan const& plan, SegmentId segment, int plants = 4000)
{
    Grower grower(plan);
    double sum = 0;
    for (int i = 0; i < plants; ++i) {
        auto const& plant
            = grower.grow({ .seed = 17, .plant_index = static_cast<std::uint32_t>(i) });
        Vec3 const direction = direction_of(plant, segment);
        double const angle = std::acos(std::clamp(direction.z(), -1.0, 1.0));
        sum += angle * angle / 2; // The square of the angle is the sum over both components.
    }
    return sum / plants;
}

// The standard error of the variances below is 1.6 %.

TEST(GrowthStatistics, NoiseHasThePredictedVariance)
{
    for (double const gain : { 0.1, 0.2, 0.5, 1.0 }) {
        auto const parameters = white_noise(gain, 0.05);
        double const theory = 0.05 * 0.05 / (gain * (2 - gain));
        EXPECT_NEAR(variance(plan_of(pole(60), parameters), 59), theory, 0.06 * theory) << gain;
    }
}

TEST(GrowthStatistics, NoiseWithMemoryHasThePredictedVariance)
{
    GrowthParameters const per_segment { .steps = Steps::PerSegment };
    EXPECT_NEAR(variance(plan_of(pole(60), per_segment), 59), steady_variance(per_segment),
                0.06 * steady_variance(per_segment));
    EXPECT_NEAR(variance(plan_of(pole(60), {}), 59), steady_variance({}),
                0.06 * steady_variance({}));
}

TEST(GrowthStatistics, TiltGrowsWithTheNoiseAsInTheReference)
{
    // The expected root mean square tilts come from the reference implementation, with 300 plants.
    auto const rms_deg = [](double noise_rad) {
        return degrees(std::sqrt(2 * variance(plan_of(pole(60), white_noise(0.2, noise_rad)), 59)));
    };
    EXPECT_NEAR(rms_deg(0.02), 2.739, 0.15);
    EXPECT_NEAR(rms_deg(0.05), 6.849, 0.35);
    EXPECT_NEAR(rms_deg(0.1), 13.697, 0.7);
}

TEST(GrowthStatistics, FinerSegmentsHaveTheSameStatistics)
{
    // The upper of two segments has its middle at 3/4 of the height, far from the base. The middles
    // of the other two segments are at the same height.
    GrowthParameters const p {};
    double const coarse = variance(plan_of(pole(2), p), 1);
    double const finer = variance(plan_of(pole(10), p), 7);
    double const fine = variance(plan_of(pole(90), p), 67);
    EXPECT_NEAR(coarse, steady_variance(p), 0.06 * steady_variance(p));
    EXPECT_NEAR(finer, steady_variance(p), 0.06 * steady_variance(p));
    EXPECT_NEAR(fine, steady_variance(p), 0.06 * steady_variance(p));
}

TEST(GrowthStatistics, FinerSegmentsSpreadTheirTipsAsFar)
{
    auto const spread_mm = [](int segments) {
        auto const plan = plan_of(pole(segments), {});
        Grower grower(plan);
        double sum = 0;
        for (std::uint32_t i = 0; i < 4000; ++i)
            sum += grower.grow({ .seed = 5, .plant_index = i })
                       .node_position_mm.back()
                       .head<2>()
                       .squaredNorm();
        return std::sqrt(sum / 4000);
    };
    double const fine = spread_mm(160);
    EXPECT_NEAR(spread_mm(20), fine, 0.05 * fine);
    // On a pole of 1000 mm, this spread is visible, but the pole keeps its shape.
    EXPECT_GT(fine, 30);
    EXPECT_LT(fine, 150);
}

TEST(GrowthStatistics, LargeAndSmallAxesVaryAlike)
{
    double const large = variance(plan_of(pole(20, 5000), {}), 19);
    double const small = variance(plan_of(pole(20, 5), {}), 19);
    EXPECT_NEAR(small, large, 1e-9 * large);
}

TEST(GrowthStatistics, StrengthScalesTheDeviation)
{
    double const usual = variance(plan_of(pole(20), {}), 19);
    double const half = variance(plan_of(pole(20), { .strength = 0.5 }), 19);
    EXPECT_NEAR(half, usual / 4, 1e-3 * usual);
}

// Tilts that the reference implementation gives for a side wind of length 1 and an indicator gain
// of 0.05. They solve gain a = 0.05 cos² a, with the angle a in radians.
struct Tilt {
    double gain = 0;
    double deg = 0;
};
constexpr Tilt kTilts[] = { { 0.05, 36.768 }, { 0.1, 23.933 }, { 0.2, 13.539 }, { 0.5, 5.674 } };

TEST(GrowthIndicators, TiltToTheFixedPoint)
{
    for (auto const& tilt : kTilts) {
        GrowthParameters const p {
            .steps = Steps::PerSegment, .strength = 0, .gain = tilt.gain, .indicator_gain = 0.05
        };
        auto const plant = grown_freely(pole(400), p, { 1, 0, 0 });
        EXPECT_NEAR(tilt_deg(plant, 399), tilt.deg, 6e-4);
        EXPECT_NEAR(direction_of(plant, 399).y(), 0, 1e-12);
    }
    GrowthParameters const at_once { .steps = Steps::PerSegment, .strength = 0, .gain = 1 };
    EXPECT_NEAR(tilt_deg(grown_freely(pole(200), at_once, { 1, 0, 0 }), 199), 2.858, 6e-4);
}

TEST(GrowthIndicators, TiltToTheSameFixedPointPerLength)
{
    for (auto const& tilt : kTilts) {
        GrowthParameters const p {
            .steps_per_axis = 400, .strength = 0, .gain = tilt.gain, .indicator_gain = 0.05
        };
        for (int const segments : { 100, 400, 1600 }) {
            auto const plant = grown_freely(pole(segments), p, { 1, 0, 0 });
            EXPECT_NEAR(tilt_deg(plant, static_cast<SegmentId>(segments - 1)), tilt.deg, 6e-4);
        }
    }
}

TEST(GrowthIndicators, TiltAnAxisOfOneSegmentAsTheMiddleOfAFineOne)
{
    for (double const strength_of_wind : { 0.3, 1.0, 3.0 }) {
        Vec3 const wind(strength_of_wind, 0, 0);
        double const fine = tilt_deg(grown_freely(pole(101), { .strength = 0 }, wind), 50);
        double const coarse = tilt_deg(grown_freely(pole(1), { .strength = 0 }, wind), 0);
        EXPECT_NEAR(coarse, fine, 0.05 * fine);
    }
}

TEST(GrowthIndicators, ReversedTheyMirrorThePlant)
{
    auto const right = grown_freely(pole(20), { .strength = 0 }, { 0.7, 0, 0.2 });
    auto const left = grown_freely(pole(20), { .strength = 0 }, { -0.7, 0, 0.2 });
    for (std::size_t i = 0; i < right.node_position_mm.size(); ++i) {
        Vec3 const mirrored = left.node_position_mm[i].cwiseProduct(Vec3(-1, 1, 1));
        EXPECT_LT((right.node_position_mm[i] - mirrored).norm(), 1e-9);
    }
}

TEST(GrowthIndicators, OppositeOnesLeaveThePlantAlone)
{
    GrowthJob job { .plant = forking_tree(4, 5), .shown_height_mm = 250 };
    auto const alone = grow(job).value();
    job.indicators = { { { 0, 0, 0 }, { 100, 50, 0 } }, { { 100, 50, 20 }, { 0, 0, 20 } } };
    EXPECT_EQ(grow(job).value().node_position_mm, alone.node_position_mm);
}

TEST(GrowthIndicators, OneLongOneIsTwoShortOnes)
{
    GrowthJob job { .plant = forking_tree(4, 5), .shown_height_mm = 250 };
    job.indicators = { { { 0, 0, 0 }, { 100, 50, 0 } }, { { 9, 9, 9 }, { 59, 9, 9 } } };
    auto const two = grow(job).value();
    job.indicators = { { { 1, 1, 1 }, { 151, 51, 1 } } };
    EXPECT_EQ(grow(job).value().node_position_mm, two.node_position_mm);
}

TEST(GrowthIndicators, BranchesFeelThemToo)
{
    // The wind blows along y, so all branches along x must turn to +y.
    auto const plant = grown_freely(hand_made_plant(), { .strength = 0 }, { 0, 1, 0 });
    for (SegmentId segment = 0; segment < plant.segment_count(); ++segment)
        EXPECT_GT(direction_of(plant, segment).y(), 0.05) << segment;
}

// Returns a curve in space. For this curve, the positions of the 30th and the last node are known
// from the reference implementation.
std::vector<Vec3> reference_curve()
{
    std::vector<Vec3> curve;
    for (int i = 0; i <= 60; ++i)
        curve.push_back({ std::sin(0.15 * i) * 2, std::cos(0.1 * i) * 1.5, 0.5 * i });
    return curve;
}

struct ReferenceRun {
    GrowthParameters parameters;
    Vec3 influence;
    Vec3 node_30;
    Vec3 node_60;
};

ReferenceRun const kReferenceRuns[] = {
    { { .steps = Steps::PerSegment, .noise_rad = 0 },
      { 1, -0.5, 0.3 },
      { 0.969124518797, -2.96302135089, 15.1150410396 },
      { 6.76624522008, -2.044461364, 29.6138924637 } },
    { { .steps = Steps::PerSegment, .delay_steps = 2, .noise_rad = 0 },
      { 1, -0.5, 0.3 },
      { 1.19219552442, -3.03384411937, 15.0651155642 },
      { 6.9706989397, -2.13454404665, 29.6155335632 } },
    { { .steps = Steps::PerSegment, .noise_rad = 0, .circumnutation_rad = 0.02 },
      { 0, 0, 0 },
      { -1.91411729795, -1.40370049157, 14.9916231389 },
      { 0.867451811922, 1.49684080177, 29.993054491 } },
    { { .steps = Steps::PerSegment,
        .gain = 0.3,
        .delay_steps = 1,
        .noise_rad = 0,
        .circumnutation_rad = 0.02 },
      { 1, -0.5, 0.3 },
      { 0.294106913155, -2.53798924223, 15.0906527006 },
      { 5.20374791846, -1.07422454818, 29.8521082236 } },
};

TEST(Growth, GoesWhereTheReferenceGoes)
{
    Plant plant;
    add_axis(plant, reference_curve());
    for (auto const& run : kReferenceRuns) {
        auto const varied = grown_freely(plant, run.parameters, run.influence);
        EXPECT_LT((varied.node_position_mm[30] - run.node_30).norm(), 1e-10);
        EXPECT_LT((varied.node_position_mm[60] - run.node_60).norm(), 1e-10);
    }
}

TEST(Growth, CirclingIsTheSameForFinerSegments)
{
    GrowthParameters const p { .noise_rad = 0, .circumnutation_rad = 0.05 };
    auto const coarse = grown_freely(pole(45), p);
    // Nine segments replace each segment. So the middle one of each nine must have the direction of
    // the old segment.
    auto const fine = grown_freely(pole(405), p);
    for (SegmentId segment = 0; segment < 45; ++segment)
        EXPECT_LT((direction_of(coarse, segment) - direction_of(fine, 9 * segment + 4)).norm(),
                  1e-12);
    EXPECT_GT(tilt_deg(coarse, 40), 1);
}

TEST(GrowthDelay, FinerSegmentsFollowTheSameTip)
{
    GrowthParameters const p { .delay_steps = 2 };
    auto const coarse = grown_freely(pole(15), p, { 0.5, 0, 0 });
    auto const fine = grown_freely(pole(135), p, { 0.5, 0, 0 });
    for (SegmentId segment = 0; segment < 15; ++segment)
        EXPECT_LT((direction_of(coarse, segment) - direction_of(fine, 9 * segment + 4)).norm(),
                  1e-9);
}

TEST(GrowthDelay, OvershootsAndSettles)
{
    GrowthParameters const at_once { .steps = Steps::PerSegment, .strength = 0 };
    GrowthParameters const late { .steps = Steps::PerSegment, .strength = 0, .delay_steps = 3 };
    auto const largest_deg = [](Plant const& plant) {
        double largest = 0;
        for (SegmentId segment = 0; segment < plant.segment_count(); ++segment)
            largest = std::max(largest, tilt_deg(plant, segment));
        return largest;
    };
    auto const plant = grown_freely(pole(200), late, { 1, 0, 0 });
    EXPECT_GT(largest_deg(plant), 1.1 * largest_deg(grown_freely(pole(200), at_once, { 1, 0, 0 })));
    EXPECT_NEAR(tilt_deg(plant, 199), 13.539, 0.01);
}

TEST(GrowthDelay, LongAxesAndLongDelaysWork)
{
    GrowthParameters const p { .gain = 0.01, .delay_steps = 64, .noise_rad = 0.01 };
    check_plant(grown_freely(pole(500), p, { 1, 0, 0 }));
    check_plant(grown_freely(pole(1), p, { 1, 0, 0 }));
}

TEST(Growth, TheWildestPlantIsStillAPlant)
{
    GrowthParameters const p { .strength = 100, .indicator_gain = 5 };
    auto const plant = grown_freely(forking_tree(6, 6), p, { 30, -20, 10 });
    check_plant(plant);
    for (SegmentId segment = 0; segment < 6; ++segment)
        EXPECT_NEAR((plant.node_position_mm[segment + 1] - plant.node_position_mm[segment]).norm(),
                    1000 / 6.0, 1e-9);
}

} // namespace
} // namespace tractus::variation
