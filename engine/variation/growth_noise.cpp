#include "engine/variation/growth_noise.h"

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tractus::variation {

namespace {

// Values of RandomKey::stream for growth.
constexpr std::uint32_t kPlantStream = 0x706c616e; // "plan": the seed of each plant.
constexpr std::uint32_t kStepStream = 0x73746570;  // "step": the noise of each step.

// Natural logarithm of a number in (0, 1], with an error below 3e-7: the logarithm of the power of
// two, plus that of the mantissa m by the series of 2 artanh((m - 1) / (m + 1)). m is within a
// factor of sqrt 2 of 1.
inline float log_of(float x)
{
    // The offset puts the mantissa in [0.7, 1.4) instead of [1, 2).
    auto const bits = std::bit_cast<std::int32_t>(x) - 0x3f3504f3;
    auto const exponent = static_cast<float>(bits >> 23);
    float const m = std::bit_cast<float>((bits & 0x007fffff) + 0x3f3504f3);
    float const t = (m - 1) / (m + 1);
    float const t2 = t * t;
    float const series
        = 2 * t * (1 + t2 * (1 / 3.f + t2 * (1 / 5.f + t2 * (1 / 7.f + t2 * (1 / 9.f)))));
    return exponent * 0.693147181f + series;
}

// Returns two normal numbers from two random words by the Box-Muller method. Two bits of
// `angle_word` choose one of four directions, a quarter turn apart; the other 30 bits add an angle
// of up to an eighth of a turn to either side.
inline std::array<float, 2> normal_pair(std::uint32_t radius_word, std::uint32_t angle_word)
{
    float const uniform
        = (static_cast<float>(static_cast<std::int32_t>(radius_word >> 8)) + 0.5f) * 0x1p-24f;
    float const radius = std::sqrt(-2 * log_of(uniform));

    float const a = static_cast<float>(static_cast<std::int32_t>(angle_word << 2)) * 0x1p-31f
        * static_cast<float>(kPi / 4);
    float const a2 = a * a;
    float const sine
        = a * (1 - a2 * (1 / 6.f - a2 * (1 / 120.f - a2 * (1 / 5040.f - a2 / 362880.f))));
    float const cosine
        = 1 - a2 * (1 / 2.f - a2 * (1 / 24.f - a2 * (1 / 720.f - a2 * (1 / 40320.f))));
    float const along = (angle_word >> 31) != 0 ? -radius : radius;
    bool const crosswise = ((angle_word >> 30) & 1) != 0;
    return { along * (crosswise ? -sine : cosine), along * (crosswise ? cosine : sine) };
}

StepNoiseLanes normal_numbers(RandomBlocks const& blocks)
{
    StepNoiseLanes noise;
    auto const& words = blocks.words;
    for (std::size_t i = 0; i < kGrowthLanes; ++i) {
        auto const pair = normal_pair(words[0][i], words[1][i]);
        noise.first[0][i] = pair[0];
        noise.first[1][i] = pair[1];
    }
    for (std::size_t i = 0; i < kGrowthLanes; ++i) {
        auto const pair = normal_pair(words[2][i], words[3][i]);
        noise.second[0][i] = pair[0];
        noise.second[1][i] = pair[1];
    }
    return noise;
}

} // namespace

GrowthNoise::GrowthNoise(PlantKey const& key)
{
    auto const words = random_block({ key.seed, kPlantStream, key.plant_index }, 0);
    seed_ = std::uint64_t { words[0] } << 32 | words[1];
}

void GrowthNoise::fill(std::uint32_t axis, std::uint32_t first, std::span<StepNoise> noise) const
{
    RandomBlocks::Words axes;
    axes.fill(axis);
    for (std::size_t begin = 0; begin < noise.size(); begin += kGrowthLanes) {
        RandomBlocks::Words steps;
        for (std::uint32_t i = 0; i < kGrowthLanes; ++i)
            steps[i] = first + static_cast<std::uint32_t>(begin) + i;
        auto const lanes = normal_numbers(random_blocks(seed_, kStepStream, axes, steps));
        auto const count = std::min(kGrowthLanes, noise.size() - begin);
        for (std::size_t i = 0; i < count; ++i)
            noise[begin + i] = { { lanes.first[0][i], lanes.first[1][i] },
                                 { lanes.second[0][i], lanes.second[1][i] } };
    }
}

void GrowthNoise::fill(std::array<std::uint32_t, kGrowthLanes> const& axes, std::uint32_t first,
                       std::span<StepNoiseLanes> noise) const
{
    RandomBlocks::Words steps;
    steps.fill(first);
    for (auto& step : noise) {
        step = normal_numbers(random_blocks(seed_, kStepStream, axes, steps));
        for (auto& number : steps)
            ++number;
    }
}

} // namespace tractus::variation
