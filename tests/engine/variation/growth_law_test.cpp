#include "engine/variation/growth_law.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace tractus::variation {
namespace {

// Covariances of the deviation d and the noise x. after() computes them for the state that follows
// a step.
struct Covariance {
    double dd = 0;
    double dx = 0;
    double xx = 0;
};

Covariance after(GrowthStep const& step, Covariance const& before)
{
    auto const a = step.deviation_kept;
    auto const b = step.noise_push;
    auto const c = step.memory_kept;
    return { a * a * before.dd + 2 * a * b * before.dx + b * b * before.xx
                 + step.noise_1 * step.noise_1,
             a * c * before.dx + b * c * before.xx + step.noise_1 * step.memory_1,
             c * c * before.xx + step.memory_1 * step.memory_1 + step.memory_2 * step.memory_2 };
}

TEST(GrowthLaw, TwoExactStepsAreOneOverBothLengths)
{
    for (double const gain : { 0.0, 0.2, 0.5, 0.9 }) {
        for (double const memory : { 0.0, 0.5, 0.8 }) {
            if (gain == 0 && memory > 0)
                continue; // This case is skipped: without feedback, memory is only approximated.
            GrowthParameters const p { .gain = gain, .noise_memory = memory };
            auto const first = exact_step(p, 0.3);
            auto const second = exact_step(p, 1.1);
            auto const both = exact_step(p, 1.4);
            EXPECT_NEAR(first.deviation_kept * second.deviation_kept, both.deviation_kept, 1e-14);
            EXPECT_NEAR(second.deviation_kept * first.noise_push
                            + second.noise_push * first.memory_kept,
                        both.noise_push, 1e-14);
            auto const two = after(second, after(first, {}));
            auto const one = after(both, {});
            EXPECT_NEAR(two.dd, one.dd, 1e-15);
            EXPECT_NEAR(two.dx, one.dx, 1e-15);
            EXPECT_NEAR(two.xx, one.xx, 1e-14);
        }
    }
}

TEST(GrowthLaw, AnExactStepOfOneIsTheUnitStep)
{
    GrowthParameters const p { .noise_memory = 0 };
    auto const exact = exact_step(p, 1);
    auto const unit = unit_step(p);
    EXPECT_NEAR(exact.deviation_kept, unit.deviation_kept, 1e-15);
    EXPECT_NEAR(exact.noise_1, unit.noise_1, 1e-15);
    EXPECT_NEAR(exact.substep_kept, unit.substep_kept, 1e-15);
    EXPECT_NEAR(exact.substep_push, unit.substep_push, 1e-15);
    EXPECT_EQ(exact.substeps, 1);
}

TEST(GrowthLaw, BothKindsOfStepTendToTheSteadyVariance)
{
    for (double const memory : { 0.0, 0.5, 0.8 }) {
        // With a gain and a memory of 0.5, both rates of the law are equal.
        for (double const gain : { 0.05, 0.2, 0.5 }) {
            GrowthParameters const p { .gain = gain, .noise_memory = memory };
            Covariance per_step;
            for (int i = 0; i < 2000; ++i)
                per_step = after(unit_step(p), per_step);
            EXPECT_NEAR(per_step.dd, steady_variance(p), 1e-12);
            EXPECT_NEAR(after(exact_step(p, 1000), {}).dd, steady_variance(p), 1e-12);
        }
    }
}

TEST(GrowthLaw, SteadyVarianceOfWhiteNoiseIsTheTextbooks)
{
    GrowthParameters const p { .gain = 0.2, .noise_rad = 0.05, .noise_memory = 0 };
    EXPECT_NEAR(steady_variance(p), 0.05 * 0.05 / (0.2 * 1.8), 1e-15);
}

TEST(GrowthLaw, AStepWithoutLengthDoesNothing)
{
    auto const step = exact_step({}, 0);
    EXPECT_EQ(step.deviation_kept, 1);
    EXPECT_EQ(step.memory_kept, 1);
    EXPECT_EQ(step.noise_1, 0);
    EXPECT_EQ(step.substep_push, 0);
}

TEST(GrowthLaw, VeryShortAndVeryLongStepsStayFinite)
{
    for (double const length : { 1e-300, 1e-9, 1e4, 1e300 }) {
        auto const step = exact_step({}, length);
        for (double const value : { step.deviation_kept, step.noise_push, step.noise_1,
                                    step.memory_1, step.memory_2, step.substep_push })
            EXPECT_TRUE(std::isfinite(value)) << length;
        EXPECT_LE(step.substeps, 4);
    }
}

// Finds the largest gain for which the delayed feedback d' = d - gain d(delay ago) decays, by
// trying it numerically.
double largest_stable_gain(int delay)
{
    double low = 0;
    double high = 2.5;
    for (int round = 0; round < 30; ++round) {
        double const gain = (low + high) / 2;
        std::vector<double> d { 1 };
        for (int n = 0; n < 4000; ++n)
            d.push_back(d.back() - gain * d[static_cast<std::size_t>(std::max(0, n - delay))]);
        (std::abs(d[4000]) < 1 && std::abs(d[3999]) < 1 ? low : high) = gain;
    }
    return low;
}

TEST(GrowthLaw, RefusesGainsThatSwingUp)
{
    for (int const delay : { 0, 1, 2, 3, 5 }) {
        GrowthParameters p { .steps = GrowthParameters::Steps::PerSegment, .delay_steps = delay };
        double const limit = largest_stable_gain(delay);
        p.gain = 0.998 * limit;
        EXPECT_TRUE(check_growth_parameters(p)) << delay;
        p.gain = 1.002 * limit;
        EXPECT_FALSE(check_growth_parameters(p)) << delay;
    }
}

TEST(GrowthLaw, SaysWhichParameterIsOutOfRange)
{
    EXPECT_EQ(
        check_growth_parameters({ .gain = 1.2 }).error().message,
        "growth: gain is 1.2, and must lie between 0 and below 1, where the feedback would swing "
        "up");
    EXPECT_EQ(check_growth_parameters({ .strength = -1 }).error().message,
              "growth: strength is -1, and must lie between 0 and 1000000");
    double const nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(check_growth_parameters({ .steps_per_axis = 0 }));
    EXPECT_FALSE(check_growth_parameters({ .strength = nan }));
    EXPECT_FALSE(check_growth_parameters({ .gain = nan }));
    EXPECT_FALSE(check_growth_parameters({ .delay_steps = 65 }));
    EXPECT_FALSE(check_growth_parameters({ .noise_rad = -0.1 }));
    EXPECT_FALSE(check_growth_parameters({ .noise_memory = 1 }));
    EXPECT_FALSE(check_growth_parameters({ .indicator_gain = nan }));
    EXPECT_FALSE(check_growth_parameters({ .circumnutation_rad = nan }));
    EXPECT_FALSE(check_growth_parameters({ .circumnutation_period_steps = 1 }));
    EXPECT_TRUE(check_growth_parameters({}));
}

} // namespace
} // namespace tractus::variation
