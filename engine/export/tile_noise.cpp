#include "engine/export/tile_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::exports {

namespace {

// Mixes the bits of a lattice point's number (a multiply-xorshift hash).
std::uint32_t mixed_bits(std::uint32_t column, std::uint32_t row, std::uint32_t layer)
{
    std::uint32_t bits = column * 0x9E3779B1U ^ row * 0x85EBCA77U ^ layer * 0xC2B2AE3DU;
    bits ^= bits >> 15;
    bits *= 0x2C1B3C6DU;
    bits ^= bits >> 12;
    bits *= 0x297A2D39U;
    bits ^= bits >> 15;
    return bits;
}

int wrapped_cell(int cell, int count)
{
    // Faster than a division, as cells are in the tile or next to it.
    while (cell < 0)
        cell += count;
    while (cell >= count)
        cell -= count;
    return cell;
}

// Calls add(column, row) for each cell, row by row.
template<typename Add> void for_each_cell(Lattice cells, Add const& add)
{
    for (int row = 0; row < cells.along; ++row)
        for (int column = 0; column < cells.across; ++column)
            add(column, row);
}

float eased_part(float t)
{
    return t * t * (3 - 2 * t);
}

} // namespace

float tile_random(int column, int row, Lattice cells, std::uint32_t layer)
{
    // 24 bits are exact in a float.
    return static_cast<float>(
               mixed_bits(static_cast<std::uint32_t>(wrapped_cell(column, cells.across)),
                          static_cast<std::uint32_t>(wrapped_cell(row, cells.along)), layer)
               >> 8)
        * 0x1p-24F;
}

TileNoise::TileNoise(Lattice cells, std::uint32_t layer)
    : cells_(cells)
{
    for_each_cell(cells, [&](int column, int row) {
        values_.push_back(tile_random(column, row, cells, layer));
    });
}

float TileNoise::at(float u, float v) const
{
    float const x = u * static_cast<float>(cells_.across);
    float const y = v * static_cast<float>(cells_.along);
    float const left = std::floor(x);
    float const low = std::floor(y);
    int const column = wrapped_cell(static_cast<int>(left), cells_.across);
    int const row = wrapped_cell(static_cast<int>(low), cells_.along);
    int const next_column = column + 1 == cells_.across ? 0 : column + 1;
    int const next_row = row + 1 == cells_.along ? 0 : row + 1;
    auto const value
        = [&](int i, int j) { return values_[static_cast<std::size_t>(j * cells_.across + i)]; };
    float const across = eased_part(x - left);
    float const along = eased_part(y - low);
    float const lower
        = value(column, row) + across * (value(next_column, row) - value(column, row));
    float const upper = value(column, next_row)
        + across * (value(next_column, next_row) - value(column, next_row));
    return lower + along * (upper - lower);
}

TileTurbulence::TileTurbulence(Lattice cells, int octaves, std::uint32_t layer)
{
    constexpr std::uint32_t kNextLayer = 101;
    for (int i = 0; i < octaves; ++i) {
        octaves_.emplace_back(cells, layer + kNextLayer * static_cast<std::uint32_t>(i));
        cells = { 2 * cells.across, 2 * cells.along };
    }
}

float TileTurbulence::at(float u, float v) const
{
    float sum = 0;
    float weight = 1;
    float weights = 0;
    for (auto const& octave : octaves_) {
        sum += weight * octave.at(u, v);
        weights += weight;
        weight *= 0.5F;
    }
    return sum / weights;
}

TileCells::TileCells(Lattice cells, float jitter, std::uint32_t layer)
    : cells_(cells)
{
    for_each_cell(cells, [&](int column, int row) {
        auto const random
            = [&](std::uint32_t which) { return tile_random(column, row, cells, layer + which); };
        seeds_.push_back(
            { 0.5F + jitter * (random(0) - 0.5F), 0.5F + jitter * (random(1) - 0.5F), random(2) });
    });
}

TileCell TileCells::at(float u, float v) const
{
    float const x = u * static_cast<float>(cells_.across);
    float const y = v * static_cast<float>(cells_.along);
    auto const column = static_cast<int>(std::floor(x));
    auto const row = static_cast<int>(std::floor(y));
    struct Found {
        float u = 0;
        float v = 0;
        float squared = 1e9F;
        float random = 0;
    };
    Found first;
    Found second;
    for (int j = row - 1; j <= row + 1; ++j)
        for (int i = column - 1; i <= column + 1; ++i) {
            auto const& seed = seeds_[static_cast<std::size_t>(
                wrapped_cell(j, cells_.along) * cells_.across + wrapped_cell(i, cells_.across))];
            Found found { x - static_cast<float>(i) - seed.u, y - static_cast<float>(j) - seed.v };
            found.squared = found.u * found.u + found.v * found.v;
            if (found.squared >= second.squared)
                continue;
            found.random = seed.random;
            second = found;
            if (second.squared < first.squared)
                std::swap(first, second);
        }
    float const between_u = first.u - second.u;
    float const between_v = first.v - second.v;
    float const between = std::max(std::sqrt(between_u * between_u + between_v * between_v), 1e-6F);
    return { .to_border = (second.squared - first.squared) / (2 * between),
             .border_tilt = std::abs(between_v) / between,
             .offset_u = first.u,
             .offset_v = first.v,
             .random = first.random };
}

} // namespace tractus::exports
