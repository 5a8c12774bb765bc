#include "engine/variation/growth_noise.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <span>
#include <vector>

namespace tractus::variation {
namespace {

constexpr std::size_t kSteps = 64;

std::vector<double> many_numbers(int axes)
{
    std::vector<double> numbers;
    GrowthNoise const source({ .seed = 3, .plant_index = 1 });
    std::array<StepNoise, kSteps> noise;
    for (int axis = 0; axis < axes; ++axis) {
        source.fill(static_cast<std::uint32_t>(axis), 0, noise);
        for (auto const& step : noise)
            numbers.insert(numbers.end(),
                           { step.first[0], step.first[1], step.second[0], step.second[1] });
    }
    return numbers;
}

TEST(GrowthNoise, IsStandardNormal)
{
    auto const numbers = many_numbers(1000);
    auto const count = static_cast<double>(numbers.size()); // 256,000 numbers are tested.
    double moments[5] = {};
    double within_one = 0;
    for (auto const x : numbers) {
        for (int power = 1; power <= 4; ++power)
            moments[power] += std::pow(x, power) / count;
        within_one += std::abs(x) < 1 ? 1 / count : 0;
        ASSERT_LT(std::abs(x), 5.9);
    }
    EXPECT_NEAR(moments[1], 0, 0.01);
    EXPECT_NEAR(moments[2], 1, 0.015);
    EXPECT_NEAR(moments[3], 0, 0.03);
    EXPECT_NEAR(moments[4], 3, 0.1);
    EXPECT_NEAR(within_one, 0.6827, 0.005);
}

TEST(GrowthNoise, NumbersOfAStepAreIndependent)
{
    auto const numbers = many_numbers(1000);
    for (std::size_t lag = 1; lag <= 8; ++lag) {
        double sum = 0;
        for (std::size_t i = lag; i < numbers.size(); ++i)
            sum += numbers[i] * numbers[i - lag];
        EXPECT_NEAR(sum / static_cast<double>(numbers.size()), 0, 0.01) << lag;
    }
}

TEST(GrowthNoise, AStepsNumbersDoNotDependOnHowTheyAreAskedFor)
{
    GrowthNoise const source({ .seed = 9 });
    std::array<StepNoise, kSteps> all;
    source.fill(7, 0, all);
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        StepNoise one;
        source.fill(7, i, std::span(&one, 1));
        EXPECT_EQ(one.first, all[i].first);
        EXPECT_EQ(one.second, all[i].second);
    }
}

TEST(GrowthNoise, AxesSideBySideHaveTheNumbersOfEach)
{
    GrowthNoise const source({ .seed = 9, .plant_index = 3 });
    std::array<std::uint32_t, kGrowthLanes> const axes { 4, 9, 9, 1, 70'000, 0, 4'000'000'000, 2 };
    std::array<StepNoiseLanes, 5> lanes;
    source.fill(axes, 11, lanes);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        std::array<StepNoise, 5> alone;
        source.fill(axes[i], 11, alone);
        for (std::size_t step = 0; step < alone.size(); ++step)
            for (std::size_t k = 0; k < 2; ++k) {
                EXPECT_EQ(lanes[step].first[k][i], alone[step].first[k]);
                EXPECT_EQ(lanes[step].second[k][i], alone[step].second[k]);
            }
    }
}

TEST(GrowthNoise, DiffersByPlantAndAxis)
{
    StepNoise noise[3];
    GrowthNoise({ .seed = 1, .plant_index = 0 }).fill(0, 0, std::span(noise, 1));
    GrowthNoise({ .seed = 1, .plant_index = 1 }).fill(0, 0, std::span(noise + 1, 1));
    GrowthNoise({ .seed = 1, .plant_index = 0 }).fill(1, 0, std::span(noise + 2, 1));
    EXPECT_NE(noise[0].first, noise[1].first);
    EXPECT_NE(noise[0].first, noise[2].first);
}

} // namespace
} // namespace tractus::variation
