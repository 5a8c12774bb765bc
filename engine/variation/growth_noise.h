#pragma once

#include "engine/base/random_blocks.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::variation {

// Names a plant of a collection. The same key always gives the same plant; keys that differ in
// anything give plants that have nothing in common but what was drawn.
struct PlantKey {
    std::uint64_t seed = 0;
    std::uint32_t plant_index = 0;
};

// The random numbers of one step of growth: two of each for the two components.
struct StepNoise {
    std::array<float, 2> first {};
    std::array<float, 2> second {};
};

// Noise for one step of several axes side by side: component, then axis.
constexpr std::size_t kGrowthLanes = RandomBlocks::kCount;
struct StepNoiseLanes {
    using Component = std::array<float, kGrowthLanes>;
    std::array<Component, 2> first {};
    std::array<Component, 2> second {};
};

// Independent standard normal numbers for the steps of one axis, a pure function of plant, axis and
// step: neither order, nor threads, nor what happens on other branches changes them. Single
// precision, at most 5.9 in size; the same bits on any machine with IEEE 754 arithmetic.
class GrowthNoise {
public:
    explicit GrowthNoise(PlantKey const& key);

    // The steps from `first` on.
    void fill(std::uint32_t axis, std::uint32_t first, std::span<StepNoise> noise) const;

    // Fills any number of steps of these axes.
    void fill(std::array<std::uint32_t, kGrowthLanes> const& axes, std::uint32_t first,
              std::span<StepNoiseLanes> noise) const;

private:
    std::uint64_t seed_ = 0;
};

} // namespace tractus::variation
