#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <vector>

namespace tractus::leaf {

// A number from 0 to 1 for a point of a grid.
double grid_hash(std::uint64_t seed, std::int64_t x, std::int64_t y);

// A square of noise that repeats in both directions, 0 to 1 in each place. Found once for the whole
// program: noise by the pixel would take longer than all else that is painted.
class NoiseTable {
public:
    // Clouds: three octaves of value noise.
    static NoiseTable const& clouds();
    // The net of the smallest veins: 1 on them, 0 between; larger meshes with smaller ones inside
    // (Worley, "A cellular texture basis function", 1996).
    static NoiseTable const& net();

    // Value at a place in meshes or clouds of the first octave; at least 0. Between the table's
    // points it is interpolated.
    float at(float x, float y) const
    {
        float const u = x * per_cell_;
        float const v = y * per_cell_;
        auto const i = static_cast<std::uint32_t>(u);
        auto const j = static_cast<std::uint32_t>(v);
        float const s = u - static_cast<float>(i);
        float const t = v - static_cast<float>(j);
        auto const* const low = row(j);
        auto const* const high = row(j + 1);
        auto const left = i & kMask;
        auto const right = (i + 1) & kMask;
        float const below = low[left] + s * (low[right] - low[left]);
        float const above = high[left] + s * (high[right] - high[left]);
        return below + t * (above - below);
    }

private:
    static constexpr std::uint32_t kSide = 256; // A power of two.
    static constexpr std::uint32_t kMask = kSide - 1;

    template<typename At> NoiseTable(int cells, At const& at);
    float const* row(std::uint32_t j) const
    {
        return values_.data() + static_cast<std::size_t>(j & kMask) * kSide;
    }

    float per_cell_ = 1; // Points of the table.
    std::vector<float> values_;
};

// A table laid over a picture: `cells` of it on the picture's side, from a place that `seed` says.
class Noise {
public:
    Noise(NoiseTable const& table, std::uint64_t seed, double cells);

    // x and y: 0 to 1 on the picture.
    float at(float x, float y) const { return table_->at(x0_ + scale_ * x, y0_ + scale_ * y); }

private:
    NoiseTable const* table_;
    float x0_;
    float y0_;
    float scale_;
};

} // namespace tractus::leaf
