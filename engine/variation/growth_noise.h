#pragma once

#include "engine/base/random_blocks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::variation {

// Identifies a plant of a collection. The same key always gives the same plant; plants of different
// keys vary independently.
struct PlantKey {
    std::uint64_t seed = 0;
    std::uint32_t plant_index = 0;
};

// The random numbers of one step of growth of an axis: two for each component of the deviation.
struct StepNoise {
    std::array<float, 2> first {};
    std::array<float, 2> second {};
};

// Number of axes whose noise is generated at once. StepNoiseLanes holds the noise of one step of
// each axis, by component, then by axis.
constexpr std::size_t kGrowthLanes = RandomBlocks::kCount;
struct StepNoiseLanes {
    using Component = std::array<float, kGrowthLanes>;
    std::array<Component, 2> first {};
    std::array<Component, 2> second {};
};

// Independent standard normal numbers for the steps of an axis. They depend only on the plant's
// key, the axis and the step, not on threads, other branches or the order of calls. Single
// precision, absolute value at most 5.9; the same bits on any machine with IEEE 754 arithmetic.
class GrowthNoise {
public:
    explicit GrowthNoise(PlantKey const& key);

    // Fills in the noise of consecutive steps, beginning with `first`.
    void fill(std::uint32_t axis, std::uint32_t first, std::span<StepNoise> noise) const;

    // Fills in the noise of the same consecutive steps for several axes.
    void fill(std::array<std::uint32_t, kGrowthLanes> const& axes, std::uint32_t first,
              std::span<StepNoiseLanes> noise) const;

private:
    std::uint64_t seed_ = 0;
};

} // namespace tractus::variation
