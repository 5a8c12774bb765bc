#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <vector>

namespace tractus::leaf {

// Returns a pseudo-random number, 0 to 1, for a grid point.
double grid_hash(std::uint64_t seed, std::int64_t x, std::int64_t y);

// A table of tileable noise with values from 0 to 1. It is computed once per program, because
// computing noise for each pixel would take longer than all other painting.
class NoiseTable {
public:
    // Clouds: three octaves of value noise.
    static NoiseTable const& clouds();
    // The network of the smallest veins: 1 on these veins, 0 between them. Its large meshes are
    // subdivided by smaller ones (Worley, "A cellular texture basis function", 1996).
    static NoiseTable const& net();

    // Interpolated value at a position in the table, at least 0 and in units of cells: for clouds()
    // those of the first octave, for net() the large meshes.
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
    // Number of entries in a row of the table, a power of two.
    static constexpr std::uint32_t kSide = 256;
    static constexpr std::uint32_t kMask = kSide - 1;

    template<typename At> NoiseTable(int cells, At const& at);
    float const* row(std::uint32_t j) const
    {
        return values_.data() + static_cast<std::size_t>(j & kMask) * kSide;
    }

    float per_cell_ = 1; // Number of table entries per cell.
    std::vector<float> values_;
};

// A noise table mapped to a picture: `cells` cells lie along the picture's side, and their offset
// is derived from `seed`.
class Noise {
public:
    Noise(NoiseTable const& table, std::uint64_t seed, double cells);

    // Value at x and y, each from 0 to 1 over the picture.
    float at(float x, float y) const { return table_->at(x0_ + scale_ * x, y0_ + scale_ * y); }

private:
    NoiseTable const* table_;
    float x0_;
    float y0_;
    float scale_;
};

} // namespace tractus::leaf
